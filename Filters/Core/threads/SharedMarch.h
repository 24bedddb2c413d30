// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_SharedMarch_h
#define geodesic_SharedMarch_h

#include "base/Index.h"
#include "base/SpinBarrier.h"
#include "solve/SolveOptions.h"
#include "threads/Mailbox.h"
#include "threads/ThreadFront.h"

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace geodesic
{

class TriangleMesh;

/** The work of a march on several threads, to reckon what more of them would give. */
struct ThreadWork
{
  std::size_t rounds = 0;
  /** The number of items taken from queues. */
  std::size_t updates = 0;
  /** The sum over all rounds of the most updates of any thread. */
  std::size_t longestChain = 0;
  /** The number of values, notices and vertices sent. */
  std::size_t sent = 0;
};

/**
 * A march that several threads share, in one field in shared memory. Each thread owns the vertices
 * of a range of numbers, that is, a part of the surface that lies together (see SpatialOrder);
 * those of them that wait are in its queue. All march in rounds, up to a common limit in each, and
 * wait for each other after it; a thread that is early goes on a little meanwhile. Where the queues
 * would take them unequal times the ranges are cut anew. Where so few vertices wait that rounds are
 * not worth it, as at the start, the first thread owns all and goes on alone.
 *
 * A thread writes the values of its own vertices only. It reads those of all vertices, also while
 * their owners write them: a value only falls, and one that was read too early makes an update too
 * large, never wrong. A thread sends to another
 *
 * - *values* for vertices of that thread;
 * - *notices*: vertices of its own that it took from its queue and that have neighbours of that
 *   thread, if that has a higher number. The other one updates round them again, now that it sees
 *   their values. So where both took one of two neighbours at the same time, their last values meet
 *   in an update; at other times the later one sees the value of the other;
 * - *gifts*: what waits for vertices, where the ranges were cut anew.
 *
 * Values and notices go to mailboxes. Threads that march together look into theirs after every few
 * vertices, and all do so at the end of the round, when they also take what found no room there. So
 * where a border runs along the way of the front, on which values go to and fro, it need not wait
 * for rounds.
 *
 * With several labels each value is of one label at a vertex, and all this holds for each label.
 *
 * As the updates are monotone the field is that of one thread to 1e-9; with several labels as far
 * as that does not depend on the order (see algorithm.md). It is not the same to the last bit from
 * run to run, as that depends on when values are read.
 */
class SharedMarch
{
public:
  static constexpr std::size_t MostThreads = 64;
  /** The most updates for each value that a vertex has. Usual are 1 to 2. It is far below that at
   * which the least gain is raised (see MarchControl). */
  static constexpr std::size_t MostUpdates = 4;
  /** The most updates of all threads together, by the number of values that vertices have. */
  static std::size_t mostUpdates(std::size_t values);

  /** Whether a front that one thread has is to be shared.
   * @param waiting    how many vertices wait: too few are not worth the rounds
   * @param unreached  how many vertices have no value: where more wait, nearly all that is left to
   *                   do has begun; with several labels, unless very many wait
   * @param labels     how many there are
   */
  static bool isToBeShared(std::size_t waiting, std::size_t unreached, std::size_t threads,
    std::size_t labels, const SolveOptions& options);

  /**
   * At first thread 0 owns all.
   * @param threads  from 1 to MostThreads
   * @param labels   how many there are
   * @param options  onProgress is called by thread 0, with the updates of all threads
   * All arguments must live as long as this.
   */
  SharedMarch(
    const TriangleMesh& mesh, std::size_t threads, std::size_t labels, const SolveOptions& options);

  /**
   * Says what was done before. To be called once, before the threads begin.
   * @param updates      how many there were
   * @param reached      how many vertices have a value
   * @param values       how many values they have, of all labels
   * @param isCancelled  whether the run was cancelled, so that there is nothing more to do
   */
  void begin(std::size_t updates, std::size_t reached, std::size_t values, bool isCancelled);
  /** To be called by a thread that ends with an error, instead of going on: ends all. */
  void fail();

private:
  enum class Content : std::uint8_t
  {
    ValueAlong,
    ValueAcross,
    Notice
  };
  struct Letter
  {
    LabelAtVertex place;
    double key;
    Content content;
  };
  using Box = Mailbox<Letter, 128>;
  /** What one thread sends to another at the end of a round. */
  struct Mail
  {
    std::vector<Letter> letters;
    std::vector<Index> gifts;
  };
  /** Rings where there are letters for a thread, of which it may still overlook some until the
   * round ends. On cache lines of its own. */
  struct alignas(128) Bell
  {
    std::atomic<bool> isRung = false;
  };
  /** The pace of a thread of which nothing is known yet; only relations count. */
  static constexpr double UsualPace = 1e-6;
  /** What a thread says after a round. Each on cache lines of its own. */
  struct alignas(128) Report
  {
    /** The least key that waits in its queue, or in letters of its own. */
    double next = std::numeric_limits<double>::infinity();
    /** In all rounds, and in this one. */
    std::size_t updates = 0;
    std::size_t roundUpdates = 0;
    /** How many items wait in its queue. */
    std::size_t waiting = 0;
    /** See ThreadFront. */
    std::size_t reached = 0;
    std::size_t values = 0;
    /** How many seconds a round takes this thread for each of them, about. */
    double pace = UsualPace;
    /** How many letters and gifts it sends. */
    std::size_t sent = 0;
    bool isCancelled = false;
    /** For each thread what is sent to it. */
    std::vector<Mail> mail;
    /** Some of the vertices that wait in its queue, where ranges are to be cut anew. */
    std::vector<Index> samples;
    /** How many vertices each of them stands for. */
    std::size_t weightOfSample = 0;
  };
  /** What all reports of a round say together. */
  struct Summary;

public:
  /** A thread's side of the march. */
  class Share
  {
  public:
    Share(SharedMarch& march, std::size_t thread);

    std::size_t number() const { return this->Number; }
    /** The first of the vertices that this thread owns, and how many there are. */
    Index first() const { return this->First; }
    Index count() const { return this->Count; }
    /** Whether this thread owns a vertex. */
    bool owns(Index vertex) const { return vertex - this->First < this->Count; }
    /** The owner of a vertex. */
    std::size_t ownerOf(Index vertex) const;
    /** How many values others gave to vertices that had none of the label, up to the last round. */
    std::size_t valuesOfOthers() const { return this->ValuesOfOthers; }
    /** Sends a value to the owner of a vertex, see ThreadFront::lower(). */
    void send(const LabelAtVertex& place, double key, bool isAlong);

    /** Marches until nothing is left to do for any thread.
     * @return false when cancelled
     * @throws FrontDoesNotSettle where all together take more than MostUpdates */
    bool march(ThreadFront& front);

  private:
    /** Waits for the reports of all threads, and begins the next one. Where another thread failed
     * the run is cancelled. */
    Summary meet();
    void send(std::size_t receiver, const Letter& letter);
    /** Takes a letter. */
    static void take(const Letter& letter, ThreadFront& front);
    /** Takes what is in the mailboxes. */
    void takeLetters(ThreadFront& front);
    /** Takes what was sent in the round before, and maybe since. */
    void takeMail(ThreadFront& front);
    /** Sends notices, and takes what others have sent meanwhile, once in several calls. */
    void exchange(ThreadFront& front);
    /** Whether the first thread owns all vertices. */
    bool isOfOne() const { return this->Ends[0] == this->Ends.back(); }
    /** Changes who owns what if that is due. @return false where another thread failed */
    bool adapt(const Summary& round, ThreadFront& front);
    /** Makes ranges of equal work. @return false where another thread failed */
    bool cutRanges(ThreadFront& front);
    /** Notes some of the vertices that wait. */
    void takeSamples(const ThreadFront& front);
    /** Finds the ends of ranges from the samples of all. */
    void findEnds();
    /** Sets this thread's range by the ends of all. */
    void setRange();
    /** Gives away what waits where this thread is no owner any more, and takes what it now owns.
     * @return false where another thread failed */
    bool handOver(ThreadFront& front);
    /** Marches up to a value, and says what this thread then has to say. */
    void advance(ThreadFront& front, double end);
    /** Does so while others march too. Where all run at the same time, learns how long it takes,
     * and goes on while it would wait for others. */
    void goOnTogether(ThreadFront& front, double end);
    /** Marches up to a value, and on until the front is to be shared. */
    void goOnAlone(ThreadFront& front, double end);
    void sendNotices(ThreadFront& front);

    Report& report() { return this->March.Reports[this->Parity][this->Number]; }
    const std::vector<Report>& lastReports() const
    {
      return this->March.Reports[this->Parity ^ 1u];
    }

    SharedMarch& March;
    std::size_t Number;
    /** Even and odd rounds take turns in what they write. */
    std::size_t Parity = 0;
    /** For each thread the vertex after its last one. Each thread computes the same. */
    std::vector<Index> Ends;
    Index First = 0;
    Index Count = 0;
    std::size_t ValuesOfOthers = 0;
    /** How often exchange() was called. */
    std::size_t Calls = 0;
    double Pace = UsualPace;
    std::vector<std::pair<Index, std::size_t>> Samples;
  };

  /** Whether the run was cancelled, once the march has ended. */
  bool wasCancelled() const { return this->WasCancelled; }
  /** The work of the march, once it has ended. */
  const ThreadWork& work() const { return this->Work; }

private:
  /** Reports progress of all threads; false once the run is cancelled. Of thread 0. */
  bool mayGoOn(std::size_t updates);

  const TriangleMesh& Mesh;
  std::size_t Labels;
  const SolveOptions& Options;
  /** What was done before the march. */
  std::size_t UpdatesBefore = 0;
  std::size_t ReachedBefore = 0;
  std::size_t ValuesBefore = 0;
  /** At how many updates thread 0 reports next. */
  std::size_t NextReport = 0;
  /** Where threads take turns on a processor, what a round takes says nothing, and none is early.
   */
  bool RunAtOnce;
  /** For even and odd rounds, by thread. */
  std::array<std::vector<Report>, 2> Reports;
  /** By receiver and sender. */
  std::vector<std::vector<Box>> Boxes;
  std::vector<Bell> Bells;
  SpinBarrier Together;
  ThreadWork Work;
  bool WasCancelled = false;
};

}

#endif
