// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_distributed_Agreement_h
#define geodesic_distributed_Agreement_h

#include <functional>
#include <span>
#include <stdexcept>
#include <string>

class vtkMultiProcessController;

namespace geodesic::distributed
{

/** An error that all ranks throw at once, with the same message. */
class AgreedError : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

/** What ranks do together after an agreement. */
enum class Phase
{
  End,
  Step,
  Gather,
  Least,
  FromFirst,
  ToFirst,
  Exchange
};

/**
 * Runs what several ranks do together as a sequence of phases, so that no rank ever waits for one
 * that failed.
 *
 * In a phase each rank first works on its own, and this may fail. Then all ranks agree: each tells
 * the others whether it failed, and what it is about to do. Only then do they send data. A rank
 * that throws an exception anywhere leaves its work, comes to run(), and there takes part in the
 * one agreement that the others come to next, whatever that is for. So all throw an AgreedError at
 * the same time. The same holds if the ranks are about to do different things, which is an error in
 * this program. The end of the run is an agreement as well.
 *
 * This is so by construction: the controller, without which nothing can be sent, is private here,
 * and the functions that give it away agree first.
 */
class Agreement
{
public:
  /** @param controller null: this process is the only rank, and nothing is sent */
  explicit Agreement(vtkMultiProcessController* controller);

  int size() const { return this->Size; }
  int rank() const { return this->Rank; }

  /**
   * Runs @p work, which calls the other functions in the same order on all ranks.
   * @throws AgreedError on all ranks if any threw; the message is that of the lowest rank that
   * failed first. If there is only one rank, its own exceptions go through.
   */
  void run(const std::function<void()>& work);

  /** Runs a step, which can't send, and agrees that no rank failed in it. */
  void together(const std::function<void()>& step);

  /**
   * Agrees that no rank has failed and that all are about to do the same.
   * @param least values of this rank, as many on all ranks; each is replaced by the least of all
   * ranks. Up to MostValues are free: they travel along with the agreement.
   * @return what to send with
   * @pre there are several ranks
   */
  vtkMultiProcessController& agree(Phase phase, std::span<double> least = {});
  static constexpr std::size_t MostValues = 5;

  /**
   * Runs a step, which can't send, before an exchange for which the ranks do not agree once more.
   * If it throws, this rank exchanges all the same, and the next agreement fails.
   * @return what to send with
   * @pre there are several ranks
   */
  vtkMultiProcessController& after(const std::function<void()>& step);

private:
  /** Runs a step in which agree() throws. */
  void runStep(const std::function<void()>& step);
  /** Takes part in the next agreement with a failure. */
  [[noreturn]] void fail(const std::string& message);
  /** Throws what the lowest rank of those that failed says. */
  [[noreturn]] void throwFailure();

  vtkMultiProcessController* Controller;
  int Size = 1;
  int Rank = 0;
  bool IsInStep = false;
  bool HasFailed = false;
  std::string Failure;
  /** How many phases this rank has begun; for faults that tests inject. */
  int PhasesBegun = 0;
};

}

#endif
