#ifndef geodesic_SolveOptions_h
#define geodesic_SolveOptions_h

#include "Index.h"
#include "SurfacePoint.h"

#include <cstdint>
#include <functional>
#include <limits>
#include <span>

namespace geodesic
{

/** A source of the front. Seeds are told apart by their position in the list. */
struct Seed
{
  SurfacePoint point;
  /** Distance at the seed itself, at least 0, in the mesh's length unit. */
  double value = 0.0;
};

/** Which of the targets must be final before the front may stop. */
enum class TargetMode
{
  Any,
  All
};

struct SolveOptions
{
  /** One flag a vertex: non-zero ones are never entered by the front. Empty: none. */
  std::span<const std::uint8_t> excluded;
  /** No vertex farther than this gets a distance, every nearer one gets its final one. */
  double maximumDistance = std::numeric_limits<double>::infinity();
  /** Vertices to reach; nothing farther than the last one needed gets a distance. Empty: none. */
  std::span<const Index> targets;
  TargetMode targetMode = TargetMode::Any;
  /**
   * Called with the number of vertices taken from the queue so far, each time that another
   * @a progressInterval were; returning false cancels the run.
   */
  std::function<bool(std::size_t)> onProgress;
  std::size_t progressInterval = 100;
};

}

#endif
