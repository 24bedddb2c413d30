// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "LiveUpdate.h"

#include "FieldSketch.h"
#include "PathSketch.h"
#include "SeedOverlay.h"

#include "pqApplicationCore.h"
#include "pqPipelineSource.h"
#include "pqRenderView.h"
#include "pqServerManagerModel.h"
#include "pqSettings.h"
#include "pqUndoStack.h"
#include "pqView.h"
#include "vtkSMDoubleVectorProperty.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMProxy.h"
#include "vtkSMTrace.h"

namespace seeds
{
namespace
{

constexpr const char* Setting = "SurfaceSeeds/LiveUpdate";

}

LiveUpdate::LiveUpdate(
  vtkSMProxy* filter, vtkSMDoubleVectorProperty* property, vtkSMProperty* dragged)
  : Filter(filter)
  , Property(property)
  , Dragged(dragged)
{
  this->Sketches.push_back(std::make_unique<PathSketch>(filter));
  this->Sketches.push_back(std::make_unique<FieldSketch>(filter));
  // Qt handles the movements that came during an update before this timer fires, so that only the
  // last of them is computed.
  this->WhenIdle.setSingleShot(true);
  this->WhenIdle.setInterval(0);
  this->connect(&this->WhenIdle, &QTimer::timeout, this, &LiveUpdate::update);
}

bool LiveUpdate::isWanted(double runTime)
{
  const bool isFast = runTime > 0.0 && runTime < FastRun;
  return pqApplicationCore::instance()->settings()->value(Setting, isFast).toBool();
}

void LiveUpdate::setWanted(bool isWanted)
{
  pqApplicationCore::instance()->settings()->setValue(Setting, isWanted);
}

bool LiveUpdate::isPossible() const
{
  auto* source =
    pqApplicationCore::instance()->getServerManagerModel()->findItem<pqPipelineSource*>(
      this->Filter.Get());
  return source && source->modifiedState() != pqProxy::UNINITIALIZED;
}

void LiveUpdate::begin(pqRenderView* view, SeedOverlay* overlay, double tolerance)
{
  this->View = view;
  this->Overlay = overlay;
  this->Tolerance = tolerance;
  const std::vector<double> elements = vtkSMPropertyHelper(this->Property).GetArray<double>();
  this->Before = QVector<double>(elements.begin(), elements.end());
  this->Latest = this->Before;
  this->IsGiven = false;
}

void LiveUpdate::push(const QVector<double>& values)
{
  this->Latest = values;
  this->WhenIdle.start();
}

void LiveUpdate::give(const QVector<double>& values, bool isDragged)
{
  if (this->Dragged)
  {
    vtkSMPropertyHelper(this->Dragged).Set(isDragged ? 1 : 0);
  }
  this->Property->SetElements(values.data(), static_cast<unsigned int>(values.size()));
  this->Filter->UpdateVTKObjects();
}

void LiveUpdate::update()
{
  this->beginSketch();
  {
    SCOPED_UNDO_EXCLUDE();
    this->give(this->Latest, true);
    this->IsGiven = true;
  }
  if (this->Current && !this->Current->update())
  {
    this->endSketch();
  }
  if (!this->Current)
  {
    this->draw();
  }
}

void LiveUpdate::beginSketch()
{
  for (const auto& sketch : this->Sketches)
  {
    if (!this->Current && this->View && this->Overlay &&
      sketch->begin(this->View, this->Overlay, this->Tolerance))
    {
      this->Current = sketch.get();
    }
  }
}

void LiveUpdate::endSketch()
{
  if (this->Current)
  {
    this->Current->end();
    this->Current = nullptr;
  }
}

void LiveUpdate::draw()
{
  const auto views = pqApplicationCore::instance()->getServerManagerModel()->findItems<pqView*>();
  for (pqView* view : views)
  {
    view->forceRender();
  }
}

void LiveUpdate::giveLast()
{
  SCOPED_UNDO_EXCLUDE();
  this->give(this->Latest, false);
}

void LiveUpdate::abandon()
{
  this->WhenIdle.stop();
  if (this->IsGiven)
  {
    this->giveLast();
  }
  if (this->Current && this->View)
  {
    this->View->render();
  }
  this->endSketch();
}

void LiveUpdate::finish()
{
  this->WhenIdle.stop();
  const bool isSketched = this->Current;
  this->endSketch();
  if (this->Latest == this->Before && !isSketched)
  {
    if (this->IsGiven)
    {
      this->giveLast();
      this->draw();
    }
    return;
  }
  {
    SCOPED_UNDO_EXCLUDE();
    this->give(this->Before, false);
  }
  {
    SCOPED_UNDO_SET(tr("Drag a point"));
    SM_SCOPED_TRACE(PropertiesModified).arg("proxy", this->Filter);
    this->give(this->Latest, false);
  }
  this->draw();
}

}
