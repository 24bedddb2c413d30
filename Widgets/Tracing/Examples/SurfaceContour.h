// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_examples_SurfaceContour_h
#define geodesic_examples_SurfaceContour_h

#include "SurfaceWindow.h"

#include "vtkContourWidget.h"
#include "vtkOrientedGlyphContourRepresentation.h"
#include "vtkPolygonalSurfaceContourLineInterpolator2.h"

#include <array>
#include <functional>
#include <vector>

class vtkObject;

namespace geodesic::examples
{

/**
 * A contour that is traced on a surface by the mouse and the keys of vtkContourWidget. A click
 * places a node, a click on the first node closes the contour, and the right button ends an open
 * contour. After that, nodes can be dragged, and Delete deletes the node under the pointer. In
 * addition, the key z undoes the last change.
 */
class SurfaceContour
{
public:
  /**
   * @param window must outlive this object
   * @param method,order,heightOffset see vtkPolygonalSurfaceContourLineInterpolator2
   */
  SurfaceContour(SurfaceWindow& window, int method, int order, double heightOffset);

  /** Sets what is called after each change; after a drag only once, at its end. */
  void onChange(std::function<void()> action) { this->Action = std::move(action); }

  /**
   * Replaces all nodes.
   * @throws std::invalid_argument if an id is not a point of the surface
   */
  void setNodes(const std::vector<vtkIdType>& pointIds);

  int numberOfNodes() const { return this->Representation->GetNumberOfNodes(); }
  bool isClosed() const { return this->Representation->GetClosedLoop() != 0; }
  /**
   * The ids along the contour, see
   * vtkPolygonalSurfaceContourLineInterpolator2::GetContourPointIds().
   */
  std::vector<vtkIdType> pointIds() const;
  /** The ids of the nodes alone. */
  std::vector<vtkIdType> nodeIds() const;
  /**
   * The length of the lines, which run between the points of the surface that are nearest to the
   * nodes.
   */
  double length() const;

private:
  struct Node
  {
    vtkIdType id;
    std::array<double, 3> position;
    bool operator==(const Node&) const = default;
  };
  struct State
  {
    std::vector<Node> nodes;
    bool isClosed = false;
    bool isFinished = false;
    bool operator==(const State&) const = default;
  };

  State state() const;
  void restore(const State& state);
  void remember(vtkObject*, unsigned long, void*);
  void onKey(vtkObject*, unsigned long, void*);
  void onWidgetEvent(vtkObject*, unsigned long, void*);

  SurfaceWindow& Window;
  vtkNew<vtkPolygonalSurfaceContourLineInterpolator2> Interpolator;
  vtkNew<vtkOrientedGlyphContourRepresentation> Representation;
  vtkNew<vtkContourWidget> Widget;
  std::vector<State> History;
  std::function<void()> Action;
};

}

#endif
