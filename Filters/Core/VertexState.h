#ifndef geodesic_VertexState_h
#define geodesic_VertexState_h

namespace geodesic
{

/** What a march notes of a vertex beside its value. */
struct VertexState
{
  /** It waits to be swept with its value. */
  bool isQueued = false;
  /** It keeps its value, whatever is proposed. */
  bool isPinned = false;
};

}

#endif
