// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "algorithm/FoundPath.h"

#include "base/Index.h"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <utility>
#include <vector>

namespace geodesic::distributed
{
namespace
{

/** What a rank tells of a path. */
struct FoundHeader
{
  Index number;
  std::uint32_t hasPath;
  std::uint32_t isProvenShortest;
  std::uint32_t numberOfPoints;
  double cost;
};

/** What all ranks know of it. */
struct Known
{
  std::uint8_t isKnown;
  std::uint8_t hasPath;
  std::uint8_t isProvenShortest;
};

RankGroup::Message packed(std::span<const FoundPath> found)
{
  RankGroup::Message message;
  for (Index number = 0; number < found.size(); ++number)
  {
    if (const auto& [isKnown, hasPath, isProven, cost, path] = found[number]; isKnown)
    {
      append(message,
        FoundHeader{ number, hasPath ? 1u : 0u, isProven ? 1u : 0u,
          static_cast<std::uint32_t>(path.size()), cost });
      const RankGroup::Message points = bytesOf<GlobalPathPoint>(path);
      message.insert(message.end(), points.begin(), points.end());
    }
  }
  return message;
}

void unpack(const RankGroup::Message& message, std::span<FoundPath> found)
{
  for (const char* at = message.data(); at < message.data() + message.size();)
  {
    FoundHeader header;
    std::memcpy(&header, at, sizeof(header));
    at += sizeof(header);
    GlobalPath path(header.numberOfPoints);
    std::memcpy(path.data(), at, path.size() * sizeof(GlobalPathPoint));
    at += path.size() * sizeof(GlobalPathPoint);
    found[header.number] = { true, header.hasPath != 0, header.isProvenShortest != 0, header.cost,
      std::move(path) };
  }
}

}

void gatherOnFirst(RankGroup& ranks, std::span<FoundPath> found)
{
  for (const RankGroup::Message& message : ranks.toFirst(packed(found)))
  {
    unpack(message, found);
  }
  tellAll(ranks, found);
}

void tellAll(RankGroup& ranks, std::span<FoundPath> found)
{
  std::vector<Known> known(found.size());
  std::transform(found.begin(), found.end(), known.begin(),
    [](const FoundPath& one)
    {
      const auto flag = [](bool isSet) { return static_cast<std::uint8_t>(isSet ? 1 : 0); };
      return Known{ flag(one.isKnown), flag(one.hasPath), flag(one.isProvenShortest) };
    });
  known = valuesIn<Known>(ranks.fromFirst(bytesOf<Known>(known)));
  for (std::size_t i = 0; i < found.size() && ranks.rank() > 0; ++i)
  {
    found[i] = { known[i].isKnown != 0, known[i].hasPath != 0, known[i].isProvenShortest != 0, 0.0,
      {} };
  }
}

}
