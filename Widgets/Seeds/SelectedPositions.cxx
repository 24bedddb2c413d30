// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "SelectedPositions.h"

#include "pqOutputPort.h"
#include "pqPVApplicationCore.h"
#include "pqPipelineSource.h"
#include "pqSelectionManager.h"
#include "pqUndoStack.h"
#include "vtkAlgorithm.h"
#include "vtkCellCenters.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataSet.h"
#include "vtkNew.h"
#include "vtkPVDataInformation.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMSessionProxyManager.h"
#include "vtkSMSourceProxy.h"
#include "vtkSmartPointer.h"

namespace seeds
{
namespace
{

/** Makes a filter on the server that the user does not see. */
vtkSmartPointer<vtkSMSourceProxy> filterOf(vtkSMProxy* input, unsigned int port, const char* name)
{
  vtkSmartPointer<vtkSMProxy> proxy;
  proxy.TakeReference(input->GetSessionProxyManager()->NewProxy("filters", name));
  proxy->PrototypeOn();
  vtkSMPropertyHelper(proxy, "Input").Set(input, port);
  return vtkSMSourceProxy::SafeDownCast(proxy);
}

vtkSmartPointer<vtkSMSourceProxy> updated(vtkSmartPointer<vtkSMSourceProxy> filter)
{
  filter->UpdateVTKObjects();
  filter->UpdatePipeline();
  return filter;
}

/**
 * Appends the positions of an extracted part of a data set. Selected points are extracted as
 * vertices.
 */
void appendPositions(vtkDataObject* data, QVector<Position>& positions)
{
  if (auto* blocks = vtkCompositeDataSet::SafeDownCast(data))
  {
    const auto block = vtk::TakeSmartPointer(blocks->NewIterator());
    for (block->InitTraversal(); !block->IsDoneWithTraversal(); block->GoToNextItem())
    {
      appendPositions(block->GetCurrentDataObject(), positions);
    }
  }
  else if (auto* part = vtkDataSet::SafeDownCast(data))
  {
    vtkNew<vtkCellCenters> centers;
    centers->SetInputDataObject(part);
    if (part->GetMaxCellSize() > 1)
    {
      centers->Update();
      part = centers->GetOutput();
    }
    for (vtkIdType i = 0; i < part->GetNumberOfPoints(); ++i)
    {
      Position position;
      part->GetPoint(i, position.data());
      positions.append(position);
    }
  }
}

/** Returns the output of a filter, gathered from all ranks and brought to the client. */
QVector<Position> fetched(vtkSMSourceProxy* filter)
{
  const auto gather = filterOf(filter, 0, "ReductionFilter");
  const bool isComposite = filter->GetDataInformation(0)->IsCompositeDataSet();
  vtkSMPropertyHelper(gather, "PostGatherHelperName")
    .Set(isComposite ? "vtkMultiBlockDataGroupFilter" : "vtkAppendFilter");
  updated(gather);
  const auto bring = filterOf(gather, 0, "ClientServerMoveData");
  vtkPVDataInformation* information = gather->GetDataInformation(0);
  const int compositeType = information->GetCompositeDataSetType();
  vtkSMPropertyHelper(bring, "OutputDataType")
    .Set(compositeType > 0 ? compositeType : information->GetDataSetType());
  updated(bring);
  QVector<Position> positions;
  auto* client = vtkAlgorithm::SafeDownCast(bring->GetClientSideObject());
  appendPositions(client->GetOutputDataObject(0), positions);
  return positions;
}

}

QVector<Position> selectedPositions()
{
  SCOPED_UNDO_EXCLUDE();
  pqOutputPort* port = pqPVApplicationCore::instance()->selectionManager()->getSelectedPort();
  vtkSMSourceProxy* selection = port ? port->getSelectionInput() : nullptr;
  if (!selection)
  {
    return {};
  }
  const auto extracted =
    filterOf(port->getSource()->getProxy(), port->getPortNumber(), "ExtractSelection");
  vtkSMPropertyHelper(extracted, "Selection").Set(selection, port->getSelectionInputPort());
  updated(extracted);
  return fetched(extracted);
}

}
