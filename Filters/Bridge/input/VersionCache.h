// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_bridge_VersionCache_h
#define geodesic_bridge_VersionCache_h

#include <memory>
#include <mutex>
#include <utility>
#include <vector>

namespace geodesic::bridge
{

/**
 * Finds an object again that was made from an input, by the input's version, for as long as
 * somebody holds the object. Safe to use from several threads; only one of them makes an object at
 * a time.
 */
template <class Version, class Made>
class VersionCache
{
public:
  /** An object that somebody holds, and the version that it was made for. */
  struct Held
  {
    Version version;
    std::shared_ptr<Made> made;
  };

  /**
   * Returns the object that was made for a version, or else the result of @p make.
   * @param make called as make(version, held) with what was made for other versions, so that it can
   *             take parts of that; the newest comes first
   */
  template <class Make>
  std::shared_ptr<Made> get(Version version, const Make& make)
  {
    const std::lock_guard lock(this->Mutex);
    std::erase_if(this->Known, [](const auto& known) { return known.second.expired(); });
    std::vector<Held> held;
    for (auto known = this->Known.rbegin(); known != this->Known.rend(); ++known)
    {
      // Meanwhile another thread may have let go of it.
      if (std::shared_ptr<Made> made = known->second.lock())
      {
        if (known->first == version)
        {
          return made;
        }
        held.push_back({ known->first, std::move(made) });
      }
    }
    std::shared_ptr<Made> made = make(std::as_const(version), std::as_const(held));
    this->Known.emplace_back(std::move(version), made);
    return made;
  }

private:
  std::mutex Mutex;
  std::vector<std::pair<Version, std::weak_ptr<Made>>> Known;
};

}

#endif
