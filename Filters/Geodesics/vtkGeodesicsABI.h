// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkGeodesicsABI.h
 * @brief Lets the article's classes live in one process with ParaView's plugin GeodesicMeasurement.
 *
 * That plugin has classes of the same names, but of other layouts, and ParaView opens plugins
 * RTLD_GLOBAL. So ours differ in
 * - their symbols: GEODESICS_ABI_BEGIN and GEODESICS_ABI_END put a class, and each forward
 *   declaration of it, into an inline namespace;
 * - their VTK name: vtkGeodesicsTypeMacro stands for vtkTypeMacro and puts the namespace into
 *   GetClassName(), so that SafeDownCast tells the two apart;
 * - their Python registration, which goes by that VTK name. By the plain one Python would take
 *   objects of that plugin for ours, and ours for its.
 * The names that C++ and Python code writes stay the plain ones.
 */
#ifndef vtkGeodesicsABI_h
#define vtkGeodesicsABI_h

#include "vtkSetGet.h"

#ifdef __VTK_WRAP__ // The wrapping tools must see plain global classes.

#define GEODESICS_ABI_BEGIN
#define GEODESICS_ABI_END
#define vtkGeodesicsTypeMacro(thisClass, superclass) vtkTypeMacro(thisClass, superclass)

#else

// clang-format off
#define GEODESICS_ABI_BEGIN inline namespace geodesics_abi {
#define GEODESICS_ABI_END }
#define vtkGeodesicsTypeMacro(thisClass, superclass)                                               \
  vtkAbstractTypeMacroWithNewInstanceType(                                                         \
    thisClass, superclass, thisClass, "geodesics_abi::" #thisClass)                                \
                                                                                                   \
protected:                                                                                         \
  vtkObjectBase* NewInstanceInternal() const override { return thisClass::New(); }                 \
                                                                                                   \
public:
// clang-format on

#endif

#ifdef VTK_WRAPPING_CXX // The code that the wrapping tools made registers the class with this call.
#define PyVTKClass_Add(type, methods, name, constructor)                                           \
  PyVTKClass_Add(type, methods, "geodesics_abi::" name, constructor)
#endif

#endif
