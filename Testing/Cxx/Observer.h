// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_testing_Observer_h
#define geodesic_testing_Observer_h

#include "vtkCallbackCommand.h"
#include "vtkNew.h"

#include <functional>

namespace geodesic::testing
{

/** Calls a function on an event of an object. */
class Observer
{
public:
  Observer(vtkObject* object, unsigned long event, std::function<void()> action)
    : Action(std::move(action))
  {
    this->Command->SetClientData(this);
    this->Command->SetCallback(
      [](vtkObject*, unsigned long, void* self, void*) { static_cast<Observer*>(self)->Action(); });
    object->AddObserver(event, this->Command);
  }

private:
  std::function<void()> Action;
  vtkNew<vtkCallbackCommand> Command;
};

}

#endif
