// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_distributed_RankGroup_h
#define geodesic_distributed_RankGroup_h

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
 * The ranks that have a piece each of a surface, and the ways in which they speak. All calls are
 * collective; on one rank they cost next to nothing.
 */
class RankGroup
{
public:
  using Message = std::vector<char>;

  /** @param controller null: this process is the only rank */
  explicit RankGroup(vtkMultiProcessController* controller);

  int size() const { return this->Size; }
  int rank() const { return this->Rank; }

  /** What all ranks give, one after the other; small things only. */
  std::vector<double> gather(std::span<const double> own);
  /** What all ranks give, rank by rank. */
  std::vector<std::vector<double>> gatherByRank(std::span<const double> own);
  /** The least of what the ranks give for each of the values, which are as many on all. */
  void takeLeast(std::span<double> values);
  double sum(double own);
  /** What the first rank gives. */
  Message fromFirst(Message message);
  /** What each rank gives, on the first rank; nothing on the others. */
  std::vector<Message> toFirst(const Message& own);
  /** Whether it is so on any rank. */
  bool isAny(bool own) { return this->sum(own ? 1.0 : 0.0) > 0.0; }
  /**
   * A number that all ranks get and never got before, for what they made together; more than 0.
   */
  double newNumber();
  /** Whether all ranks give one and the same such number. */
  bool haveSame(double number);
  /** This rank's share of the processors of its machine, at least 1. */
  unsigned threadsOfThisRank();

  /**
   * Runs a step that makes no collective call. Where it throws on one rank, all ranks throw, with
   * the message of the lowest one.
   */
  void together(const std::function<void()>& step);

  /**
   * Throws on all ranks unless all give the same values.
   * @param what they are, for the message
   */
  void requireSame(std::span<const double> values, const std::string& what);

  /**
   * Sends a message to each partner and returns theirs.
   * @param partners other ranks, in the order of their number xor this rank's. Then no two ranks
   *                 wait for each other in a circle, and pairs speak side by side.
   */
  std::vector<Message> exchange(
    std::span<const int> partners, const std::vector<Message>& messages);
  /** All other ranks, in that order. */
  std::vector<int> others() const;
  /** Puts ranks into that order. */
  void sort(std::vector<int>& partners) const;

private:
  void send(const Message& message, int partner);
  Message receive(int partner);
  bool isFirstToSend(int partner) const { return this->Rank < partner; }

  vtkMultiProcessController* Controller;
  int Size = 1;
  int Rank = 0;
};

/** The bytes of some values of a plain type one after the other, and back. */
template <class T>
void append(RankGroup::Message& message, const T& value)
{
  const std::size_t end = message.size();
  message.resize(end + sizeof(T));
  std::memcpy(message.data() + end, &value, sizeof(T));
}

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
