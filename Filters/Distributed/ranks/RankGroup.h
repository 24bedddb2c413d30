// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_distributed_RankGroup_h
#define geodesic_distributed_RankGroup_h

#include "ranks/Agreement.h"

#include <cstddef>
#include <cstring>
#include <functional>
#include <span>
#include <string>
#include <vector>

class vtkMultiProcessController;

namespace geodesic::distributed
{

/**
 * The ranks that have a piece of a surface each, and the communication between them. All calls that
 * communicate are collective, and belong into run(); on one rank they cost next to nothing. Each
 * begins with an agreement of all ranks, see Agreement: where one has failed, all throw.
 */
class RankGroup
{
public:
  using Message = std::vector<char>;

  /** @param controller null: this process is the only rank */
  explicit RankGroup(vtkMultiProcessController* controller);

  int size() const { return this->Agreed.size(); }
  int rank() const { return this->Agreed.rank(); }

  /** See Agreement::run(). */
  void run(const std::function<void()>& work) { this->Agreed.run(work); }
  /**
   * Runs a step that can't send. If it throws on any rank, all ranks throw, with the message of the
   * lowest rank that failed.
   */
  void together(const std::function<void()>& step) { this->Agreed.together(step); }

  /**
   * Returns the values of all ranks, one rank after the other, on every rank. Only for small
   * amounts of data.
   */
  std::vector<double> gather(std::span<const double> own);
  /** Returns the values of each rank, on every rank. Only for small amounts of data. */
  std::vector<std::vector<double>> gatherByRank(std::span<const double> own);
  /**
   * Replaces each value by the least one of all ranks. All ranks must pass the same number of
   * values.
   */
  void takeLeast(std::span<double> values);
  /** Returns the sum over all ranks. */
  double sum(double own);
  /** Returns the largest of all ranks. */
  double largest(double own);
  /** Returns the first rank's message on every rank. The other ranks' messages are ignored. */
  Message fromFirst(Message message);
  /**
   * Returns the messages of all ranks, in their order, on the first rank, and nothing on the
   * others.
   */
  std::vector<Message> toFirst(const Message& own);
  /** Returns whether @p own is true on any rank. */
  bool isAny(bool own) { return this->sum(own ? 1.0 : 0.0) > 0.0; }
  /**
   * Returns a number greater than 0, the same on all ranks and different in each call. It
   * identifies what the ranks make together.
   */
  double newNumber();
  /** Returns the largest of those numbers that all ranks pass; 0 if there is none. */
  double largestCommon(std::span<const double> numbers);
  /** Returns this rank's share of the processors of its machine, at least 1. */
  unsigned threadsOfThisRank();

  /**
   * Checks that all ranks pass the same values.
   * @param what name of the values in the error message
   * @throws std::invalid_argument on all ranks if a rank's values differ from those of rank 0
   */
  void requireSame(std::span<const double> values, const std::string& what);

  /**
   * Sends a message to each partner and returns the partners' messages. All partners must do the
   * same.
   * @param partners other ranks, sorted by their number xor this rank's number. In this order ranks
   *                 never wait for each other in a circle, and pairs of ranks exchange at the same
   *                 time.
   */
  std::vector<Message> exchange(
    std::span<const int> partners, const std::vector<Message>& messages);
  /**
   * The same with messages that a step makes, which can't send. It takes no agreement: if the step
   * throws, the partners get empty messages, and all ranks throw in their next call.
   */
  std::vector<Message> exchangeAfter(
    std::span<const int> partners, const std::function<std::vector<Message>()>& step);
  /** All other ranks, in the order that exchange() needs. */
  std::vector<int> others() const;
  /** Sorts ranks into the order that exchange() needs. */
  void sort(std::vector<int>& partners) const;

private:
  Agreement Agreed;
};

/** Appends the bytes of a value of a trivially copyable type to a message. */
template <class T>
void append(RankGroup::Message& message, const T& value)
{
  const std::size_t end = message.size();
  message.resize(end + sizeof(T));
  std::memcpy(message.data() + end, &value, sizeof(T));
}

/** Returns a message of values of one type. */
template <class T>
RankGroup::Message bytesOf(std::span<const T> values)
{
  RankGroup::Message message;
  for (const T& value : values)
  {
    append(message, value);
  }
  return message;
}

/** Returns the values of one type that append() has written to a message. */
template <class T>
std::vector<T> valuesIn(const RankGroup::Message& message)
{
  std::vector<T> values(message.size() / sizeof(T));
  std::copy(message.begin(), message.begin() + values.size() * sizeof(T),
    reinterpret_cast<char*>(values.data()));
  return values;
}

}

#endif
