// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkSurfacePointPicker
 * @brief Where a ray first meets the surface of a data set, and the value of an array there.
 *
 * An interactive widget asks this class where the data are: on a server, on all of its ranks. The
 * answer lies on a face, up to rounding. The first pick on an input builds a search tree, which the
 * filters of this module share; later picks take microseconds. The input can be polygonal data, any
 * other data set (its outer surface is picked), or blocks of both.
 *
 * The present data are used; nothing is updated.
 */
#ifndef vtkSurfacePointPicker_h
#define vtkSurfacePointPicker_h

#include "vtkFiltersSurfaceGeodesicsModule.h" // For the export macro
#include "vtkObject.h"
#include "vtkSmartPointer.h" // For members

#include <memory> // For members
#include <string> // For members

class vtkAlgorithmOutput;

class VTKFILTERSSURFACEGEODESICS_EXPORT vtkSurfacePointPicker : public vtkObject
{
public:
  static vtkSurfacePointPicker* New();
  vtkTypeMacro(vtkSurfacePointPicker, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * The data to pick on.
   */
  void SetInputConnection(vtkAlgorithmOutput* input);

  ///@{
  /**
   * The ray, in the coordinates of the input; the direction has any length but 0. Default: from 0
   * along z.
   */
  vtkSetVector3Macro(Origin, double);
  vtkGetVector3Macro(Origin, double);
  vtkSetVector3Macro(Direction, double);
  vtkGetVector3Macro(Direction, double);
  ///@}

  ///@{
  /**
   * Whether the answer is the nearest corner of the triangle that the ray meets. (The nearest point
   * of the whole mesh could lie on the other side of a thin sheet.) Default: off.
   */
  vtkSetMacro(SnapToPoint, bool);
  vtkGetMacro(SnapToPoint, bool);
  vtkBooleanMacro(SnapToPoint, bool);
  ///@}

  /**
   * The point array whose value at the answer is wanted, interpolated on the triangle. Default:
   * none.
   */
  void SetArrayName(const char* name);
  const char* GetArrayName() { return this->ArrayName.c_str(); }

  /**
   * Sets the answer. Must be called on all ranks; the first rank then has the answer.
   */
  void Pick();

  /**
   * 1 and x, y, z of the point, or four zeros if the ray misses.
   */
  vtkGetVector4Macro(Answer, double);
  /**
   * The value of the array at the answer; NaN if the ray misses, or the data have no such array.
   */
  vtkGetMacro(Value, double);

protected:
  vtkSurfacePointPicker();
  ~vtkSurfacePointPicker() override;

  double Origin[3] = { 0.0, 0.0, 0.0 };
  double Direction[3] = { 0.0, 0.0, 1.0 };
  bool SnapToPoint = false;
  double Answer[4] = { 0.0, 0.0, 0.0, 0.0 };
  double Value = 0.0;
  std::string ArrayName;

private:
  struct Internals;
  std::unique_ptr<Internals> Internal;

  vtkSurfacePointPicker(const vtkSurfacePointPicker&) = delete;
  void operator=(const vtkSurfacePointPicker&) = delete;
};

#endif
