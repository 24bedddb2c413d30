// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkNearestOnLines
 * @brief The point of polylines that is nearest to a point in space, and which line it is on.
 *
 * An interactive widget asks this class where the data are: on a server, whose first rank answers
 * from its own lines. Takes time in proportion to the number of points of the lines.
 *
 * The present data are used; nothing is updated.
 */
#ifndef vtkNearestOnLines_h
#define vtkNearestOnLines_h

#include "vtkFiltersSurfaceGeodesicsModule.h" // For the export macro
#include "vtkObject.h"
#include "vtkSmartPointer.h" // For members
#include "vtkWeakPointer.h"  // For members

#include <string> // For members

class vtkAlgorithm;
class vtkAlgorithmOutput;

class VTKFILTERSSURFACEGEODESICS_EXPORT vtkNearestOnLines : public vtkObject
{
public:
  static vtkNearestOnLines* New();
  vtkTypeMacro(vtkNearestOnLines, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * The lines: a vtkPolyData.
   */
  void SetInputConnection(vtkAlgorithmOutput* input);

  ///@{
  /**
   * The point in space. Default: 0.
   */
  vtkSetVector3Macro(Position, double);
  vtkGetVector3Macro(Position, double);
  ///@}

  ///@{
  /**
   * The cell array that tells which line it is. Default: none, which is an empty answer.
   */
  void SetArrayName(const char* name);
  const char* GetArrayName() { return this->ArrayName.c_str(); }
  ///@}

  /**
   * Sets the answer.
   */
  void Find();

  /**
   * The array's value on the line and x, y and z of the nearest point; -1 and zeros if there is no
   * line, or no such array.
   */
  vtkGetVector4Macro(Answer, double);

protected:
  vtkNearestOnLines();
  ~vtkNearestOnLines() override;

  double Position[3] = { 0.0, 0.0, 0.0 };
  double Answer[4] = { -1.0, 0.0, 0.0, 0.0 };
  std::string ArrayName;

private:
  vtkSmartPointer<vtkAlgorithmOutput> Input;
  /** Null where it was deleted, which the output does not tell. */
  vtkWeakPointer<vtkAlgorithm> Producer;

  vtkNearestOnLines(const vtkNearestOnLines&) = delete;
  void operator=(const vtkNearestOnLines&) = delete;
};

#endif
