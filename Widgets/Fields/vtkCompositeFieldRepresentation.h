// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkCompositeFieldRepresentation
 * @brief ParaView's choice of representations, in which a surface is a
 * vtkSurfaceFieldRepresentation
 *
 * Where the surface is shown as such, with its edges or without, its XML names another
 * representation than the base proxy's. The class takes that one alone; its superclass would warn.
 */
#ifndef vtkCompositeFieldRepresentation_h
#define vtkCompositeFieldRepresentation_h

#include "vtkPVCompositeRepresentation.h"
#include "vtkWidgetsFieldsModule.h" // For the export macro

class VTKWIDGETSFIELDS_EXPORT vtkCompositeFieldRepresentation : public vtkPVCompositeRepresentation
{
public:
  static vtkCompositeFieldRepresentation* New();
  vtkTypeMacro(vtkCompositeFieldRepresentation, vtkPVCompositeRepresentation);

  void AddRepresentation(const char* key, vtkPVDataRepresentation* representation) override;

protected:
  vtkCompositeFieldRepresentation() = default;
  ~vtkCompositeFieldRepresentation() override = default;

private:
  vtkCompositeFieldRepresentation(const vtkCompositeFieldRepresentation&) = delete;
  void operator=(const vtkCompositeFieldRepresentation&) = delete;
};

#endif
