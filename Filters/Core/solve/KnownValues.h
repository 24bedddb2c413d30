// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_KnownValues_h
#define geodesic_KnownValues_h

#include "base/Index.h"
#include "solve/DistanceField.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace geodesic
{

/** For each vertex that several pieces share, by its slot, the lowest value of each label that was
 * sent to the other pieces or received from them. */
class KnownValues
{
public:
  /** Forgets all values. @param slots  how many there are */
  void start(std::size_t slots)
  {
    this->First.assign(slots, {});
    this->Others.clear();
  }

  /** Whether a value is lower than the known one of its slot and label. If so, it becomes that. */
  bool isNews(std::size_t slot, Index label, double value)
  {
    KnownValue& first = this->First[slot];
    first.label = first.label == NoIndex ? label : first.label;
    double& known = first.label == label
      ? first.value
      : this->Others.try_emplace(std::uint64_t{ label } << 32u | slot, DistanceField::Unreached)
          .first->second;
    const bool isLower = value < known;
    known = std::min(value, known);
    return isLower;
  }

private:
  struct KnownValue
  {
    Index label = NoIndex;
    double value = DistanceField::Unreached;
  };

  /** Of each slot the label that came there first. */
  std::vector<KnownValue> First;
  std::unordered_map<std::uint64_t, double> Others;
};

}

#endif
