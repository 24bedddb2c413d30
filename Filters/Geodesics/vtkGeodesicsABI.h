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
 *   GetClassName(). IsA() knows the plain name as well, SafeDownCast asks for the full one;
 * - their Python registration, because Python registers types, and finds the type of an object, by
 *   GetClassName(). By the plain name, Python would take objects of that plugin for ours, or ours
 *   for that plugin's, and crash on the other layout.
 *
 * The names that are written in C++ and Python code stay the plain ones.
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
protected:                                                                                         \
  const char* GetClassNameInternal() const override { return "geodesics_abi::" #thisClass; }       \
  vtkObjectBase* NewInstanceInternal() const override { return thisClass::New(); }                 \
                                                                                                   \
public:                                                                                            \
  typedef superclass Superclass;                                                                   \
  static vtkTypeBool IsTypeOf(const char* type)                                                    \
  {                                                                                                \
    return !strcmp(#thisClass, type) || !strcmp("geodesics_abi::" #thisClass, type) ||             \
      superclass::IsTypeOf(type);                                                                  \
  }                                                                                                \
  vtkTypeBool IsA(const char* type) override { return thisClass::IsTypeOf(type); }                 \
  static thisClass* SafeDownCast(vtkObjectBase* o)                                                 \
  {                                                                                                \
    return o && o->IsA("geodesics_abi::" #thisClass) ? static_cast<thisClass*>(o) : nullptr;       \
  }                                                                                                \
  VTK_NEWINSTANCE thisClass* NewInstance() const                                                   \
  {                                                                                                \
    return thisClass::SafeDownCast(this->NewInstanceInternal());                                   \
  }                                                                                                \
  static vtkIdType GetNumberOfGenerationsFromBaseType(const char* type)                            \
  {                                                                                                \
    const bool isThis = !strcmp(#thisClass, type) || !strcmp("geodesics_abi::" #thisClass, type);  \
    return isThis ? 0 : 1 + superclass::GetNumberOfGenerationsFromBaseType(type);                  \
  }                                                                                                \
  vtkIdType GetNumberOfGenerationsFromBase(const char* type) override                              \
  {                                                                                                \
    return thisClass::GetNumberOfGenerationsFromBaseType(type);                                    \
  }                                                                                                \
                                                                                                   \
public:
// clang-format on

#endif

#ifdef VTK_WRAPPING_CXX // The code that the wrapping tools made registers the class with this call.
#define PyVTKClass_Add(type, methods, name, constructor)                                           \
  PyVTKClass_Add(type, methods, "geodesics_abi::" name, constructor)
#endif

#endif
