// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "RunErrorWidget.h"

#include "ErrorNote.h"
#include "ResultNumbers.h"

#include "pqApplicationCore.h"
#include "pqPipelineSource.h"
#include "pqServerManagerModel.h"
#include "vtkSMProxy.h"

#include <QVBoxLayout>

using namespace seeds;

RunErrorWidget::RunErrorWidget(vtkSMProxy* proxy, vtkSMPropertyGroup* group, QWidget* parent)
  : pqPropertyGroupWidget(proxy, group, parent)
{
  // Nothing in it, but a note makes its margins larger.
  (new QVBoxLayout(this))->setContentsMargins(0, 0, 0, 0);
  this->connect(pqApplicationCore::instance()->getServerManagerModel(),
    &pqServerManagerModel::dataUpdated, this,
    [this](pqPipelineSource* source)
    {
      if (source->getProxy() == this->proxy())
      {
        this->showError();
      }
    });
  this->showError();
}

RunErrorWidget::~RunErrorWidget()
{
  delete this->Error;
}

void RunErrorWidget::showError()
{
  delete this->Error;
  const QString error = ResultNumbers::of(this->proxy(), this->propertyGroup()).error;
  if (!error.isEmpty())
  {
    pqPropertyWidget* named = ErrorNote::namedWidget(this, error);
    this->Error = new ErrorNote(named ? named : this, error);
  }
}
