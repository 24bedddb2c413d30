// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_Interruption_h
#define geodesic_Interruption_h

#include <cstddef>
#include <exception>
#include <functional>
#include <utility>

namespace geodesic
{

/** What Interruption::check() throws. What was under way is undefined then and must be dropped. */
class Interrupted : public std::exception
{
public:
  const char* what() const noexcept override { return "The run was interrupted."; }
};

/**
 * Lets a caller interrupt work that has no other way to end early, as it can't keep a part of what
 * it makes: a mesh, a tree of its triangles, a table of its edges. While an object of this class
 * exists, all such work of its thread asks it, several times in a tenth of a second on surfaces of
 * millions of points. Threads that the work starts don't ask. A march is cancelled by
 * SolveOptions::onProgress instead.
 */
class Interruption
{
public:
  /** @param mayGoOn  called often, so it must be cheap; false ends the work */
  explicit Interruption(std::function<bool()> mayGoOn)
    : MayGoOn(std::move(mayGoOn))
    , Outer(std::exchange(Present, this))
  {
  }
  ~Interruption() { Present = this->Outer; }
  Interruption(const Interruption&) = delete;
  Interruption& operator=(const Interruption&) = delete;

  /** To be called every few thousand steps of long work. @throws Interrupted  if it may not go on
   */
  static void check()
  {
    if (Present && !Present->MayGoOn())
    {
      throw Interrupted();
    }
  }

  /** As check(), at one of about a thousand numbers of steps. */
  static void checkAt(std::size_t step)
  {
    constexpr std::size_t interval = 1024;
    if (step % interval == 0)
    {
      check();
    }
  }

private:
  static constinit inline thread_local Interruption* Present = nullptr;
  std::function<bool()> MayGoOn;
  Interruption* Outer;
};

}

#endif
