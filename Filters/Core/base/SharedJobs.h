// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_SharedJobs_h
#define geodesic_SharedJobs_h

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace geodesic
{

/**
 * Shares out jobs that do not depend on each other over threads: whichever thread is free takes the
 * next job. The calling thread is one of them, and it alone reports progress. The others begin only
 * once the jobs have taken some steps, so that little work stays on the calling thread.
 */
class SharedJobs
{
public:
  /** Takes the steps of a job so far; false once the job must end. */
  using Progress = std::function<bool(std::size_t)>;
  /** What a job is told. */
  struct Turn
  {
    /** The number of the job. */
    std::size_t number;
    /** The number of the thread: 0 is the calling one. */
    std::size_t thread;
    /** Whether other threads may work on other jobs meanwhile. */
    bool isShared;
    const Progress& onProgress;
  };
  /** Does a job. A job that ends because onProgress returned false counts as not done. */
  using Job = std::function<void(const Turn&)>;

  /**
   * @param threads      the most threads that work at a time, at least 1
   * @param stepsAlone   how many steps the calling thread takes before others begin
   * @param stepsOfJob   how many steps a job counts for once it is done
   * @param onProgress   takes the steps of all jobs, which never fall; false ends all jobs
   */
  SharedJobs(
    std::size_t threads, std::size_t stepsAlone, std::size_t stepsOfJob, Progress onProgress)
    : StepsAlone(stepsAlone)
    , StepsOfJob(stepsOfJob)
    , OnProgress(std::move(onProgress))
    , Taken(threads)
  {
  }

  /**
   * Does jobs number 0 to count - 1. If a job throws, the jobs that others have not done by then
   * are done on the calling thread alone, one after the other, so that the error is that of one
   * thread.
   * @return for each job whether it is done: all are, unless onProgress ended them
   * @throws whatever a job throws on the calling thread alone
   */
  std::vector<bool> run(std::size_t count, const Job& job)
  {
    this->Count = count;
    this->States = std::vector<std::atomic<State>>(count);
    {
      std::vector<std::jthread> helpers;
      const auto startHelpers = [&]
      {
        const std::size_t wanted = std::min(this->Taken.size(), count);
        while (helpers.size() + 1 < wanted)
        {
          const std::size_t thread = helpers.size() + 1;
          const std::lock_guard lock(this->Mutex);
          helpers.emplace_back([this, thread, &job] { this->help(thread, job); });
          ++this->AtWork;
        }
      };
      this->Start = startHelpers;
      this->work(0, job);
      this->waitForHelpers();
    }
    this->Start = nullptr;
    for (std::size_t number = 0; number < count && this->HasFailed && !this->Cancelled; ++number)
    {
      if (this->States[number] != State::Done)
      {
        this->States[number] = this->runOne(0, number, job) ? State::Done : State::Begun;
      }
    }
    std::vector<bool> areDone(count);
    std::transform(this->States.begin(), this->States.end(), areDone.begin(),
      [](const std::atomic<State>& state) { return state == State::Done; });
    return areDone;
  }

private:
  enum class State : unsigned char
  {
    Waiting,
    Begun,
    Done
  };

  /** Takes jobs until none is left or all must end. */
  void work(std::size_t thread, const Job& job)
  {
    while (this->mayGoOn())
    {
      const std::size_t number = this->Next++;
      if (number >= this->Count)
      {
        return;
      }
      this->States[number] = State::Begun;
      try
      {
        if (this->runOne(thread, number, job))
        {
          this->States[number] = State::Done;
        }
      }
      catch (...)
      {
        // The calling thread does this job again, and meets the error itself.
        this->HasFailed = true;
      }
    }
  }

  void help(std::size_t thread, const Job& job)
  {
    this->work(thread, job);
    const std::lock_guard lock(this->Mutex);
    --this->AtWork;
    this->Ended.notify_one();
  }

  /** @return whether the job was done to its end */
  bool runOne(std::size_t thread, std::size_t number, const Job& job)
  {
    bool isWhole = true;
    const Progress onProgress = [&](std::size_t steps)
    {
      this->Taken[thread] = steps;
      isWhole = isWhole && this->reportFrom(thread);
      return isWhole;
    };
    job({ number, thread, this->Start && this->Taken.size() > 1, onProgress });
    if (isWhole)
    {
      this->Taken[thread] = 0;
      this->StepsOfDone += this->StepsOfJob;
      this->reportFrom(thread);
    }
    return isWhole;
  }

  /** Reports if this is the calling thread. @return whether the job may go on */
  bool reportFrom(std::size_t thread)
  {
    if (thread == 0)
    {
      this->report();
    }
    // The jobs that are done again after a failure may go on.
    return !this->Cancelled && (!this->HasFailed || (thread == 0 && !this->Start));
  }

  void report()
  {
    std::size_t steps = this->StepsOfDone;
    for (const std::atomic<std::size_t>& taken : this->Taken)
    {
      steps += taken;
    }
    this->Reported = std::max(this->Reported, steps);
    if (this->Start && this->Reported >= this->StepsAlone && this->Next < this->Count)
    {
      this->Start();
    }
    if (this->OnProgress && !this->OnProgress(this->Reported))
    {
      this->Cancelled = true;
    }
  }

  void waitForHelpers()
  {
    constexpr std::chrono::milliseconds interval(50);
    std::unique_lock lock(this->Mutex);
    while (!this->Ended.wait_for(lock, interval, [this] { return this->AtWork == 0; }))
    {
      lock.unlock();
      this->report();
      lock.lock();
    }
  }

  bool mayGoOn() const { return !this->Cancelled && !this->HasFailed; }

  std::size_t StepsAlone;
  std::size_t StepsOfJob;
  Progress OnProgress;
  std::size_t Count = 0;
  std::atomic<std::size_t> Next = 0;
  std::vector<std::atomic<State>> States;
  /** The steps of each thread's present job. */
  std::vector<std::atomic<std::size_t>> Taken;
  std::atomic<std::size_t> StepsOfDone = 0;
  std::atomic<bool> Cancelled = false;
  std::atomic<bool> HasFailed = false;

  // Of the calling thread only.

  /** Starts the other threads; null once they have ended. */
  std::function<void()> Start;
  std::size_t Reported = 0;

  std::mutex Mutex;
  std::condition_variable Ended;
  /** Number of other threads that have not ended; guarded by Mutex. */
  std::size_t AtWork = 0;
};

}

#endif
