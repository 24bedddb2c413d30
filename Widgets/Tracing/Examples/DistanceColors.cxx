// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "DistanceColors.h"

#include "vtkCamera.h"
#include "vtkColorTransferFunction.h"
#include "vtkDataArray.h"
#include "vtkPointData.h"
#include "vtkProperty.h"
#include "vtkSphereSource.h"
#include "vtkTextProperty.h"

namespace geodesic::examples
{
namespace
{

/**
 * Fills a table with yellow, green, blue and violet, from near to far. Every second band is darker,
 * so that isolines show.
 */
void fillBands(vtkLookupTable* table, int bands)
{
  vtkNew<vtkColorTransferFunction> colors;
  colors->SetColorSpaceToLab();
  colors->AddRGBPoint(0.0, 0.99, 0.91, 0.14);
  colors->AddRGBPoint(0.25, 0.37, 0.79, 0.38);
  colors->AddRGBPoint(0.5, 0.13, 0.57, 0.55);
  colors->AddRGBPoint(0.75, 0.23, 0.32, 0.55);
  colors->AddRGBPoint(1.0, 0.27, 0.0, 0.33);
  table->SetNumberOfTableValues(bands);
  for (int i = 0; i < bands; ++i)
  {
    double color[3];
    colors->GetColor(i / (bands - 1.0), color);
    const double shade = i % 2 == 0 ? 1.0 : 0.82;
    table->SetTableValue(i, shade * color[0], shade * color[1], shade * color[2]);
  }
}

void setText(vtkTextProperty* text)
{
  text->SetColor(0.1, 0.1, 0.1);
  text->SetFontSize(16);
  text->ItalicOff();
  text->ShadowOff();
  text->BoldOff();
}

}

DistanceColors::DistanceColors(SurfaceWindow& window)
  : Window(window)
{
  // Makes room for the scalar bar.
  window.renderer()->GetActiveCamera()->SetWindowCenter(0.17, 0.0);
  fillBands(this->Table, 24);
  this->Table->SetBelowRangeColor(0.8, 0.8, 0.8, 1.0);
  this->Table->UseBelowRangeColorOn();
  this->Bar->SetLookupTable(this->Table);
  this->Bar->SetTitle("FMMDist");
  this->Bar->SetNumberOfLabels(5);
  this->Bar->SetLabelFormat("%.3g");
  this->Bar->UnconstrainedFontSizeOn();
  this->Bar->SetPosition(0.83, 0.15);
  this->Bar->SetWidth(0.14);
  this->Bar->SetHeight(0.7);
  this->Bar->SetBarRatio(0.25);
  this->Bar->SetVerticalTitleSeparation(8);
  setText(this->Bar->GetTitleTextProperty());
  setText(this->Bar->GetLabelTextProperty());
}

void DistanceColors::show(vtkDataArray* distances, double maximum)
{
  this->Table->SetTableRange(0.0, maximum);
  this->Window.surface()->GetPointData()->SetScalars(distances);
  vtkPolyDataMapper* mapper = this->Window.mapper();
  mapper->ScalarVisibilityOn();
  mapper->SetLookupTable(this->Table);
  mapper->UseLookupTableScalarRangeOn();
  mapper->InterpolateScalarsBeforeMappingOn();
  this->Window.renderer()->AddActor2D(this->Bar);
}

void DistanceColors::markSeeds(const std::vector<vtkIdType>& pointIds)
{
  vtkPolyData* surface = this->Window.surface();
  for (const auto& mark : this->Marks)
  {
    this->Window.renderer()->RemoveActor(mark);
  }
  this->Marks.clear();
  for (vtkIdType id : pointIds)
  {
    vtkNew<vtkSphereSource> ball;
    ball->SetCenter(surface->GetPoint(id));
    ball->SetRadius(0.01 * surface->GetLength());
    ball->SetThetaResolution(24);
    ball->SetPhiResolution(24);
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputConnection(ball->GetOutputPort());
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    actor->GetProperty()->SetColor(0.85, 0.1, 0.1);
    actor->PickableOff();
    this->Window.renderer()->AddActor(actor);
    this->Marks.push_back(actor);
  }
}

}
