// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
// Recorded mouse and keys: nodes are placed, dragged, closed to a loop, deleted, and all of it
// undone.

#include "Inputs.h"
#include "SurfaceContour.h"
#include "TracedContour.h"

#include <gtest/gtest.h>

using namespace geodesic;
using namespace geodesic::testing;

namespace
{

using Ids = std::vector<vtkIdType>;
using Lines = std::vector<NotingInterpolator::Line>;

/** The square [0, 20]^2 of unit cells with a contour on it, to be traced by the mouse. */
class Events : public ::testing::Test
{
protected:
  Events()
  {
    this->Traced.addSurface(this->Surface);
    this->Traced.Interpolator->SetGeodesicMethodToFastMarching();
    this->Traced.Interpolator->SetInterpolationOrder(1);
    this->Traced.Window->Render();
  }

  static vtkIdType idAt(int x, int y) { return vtkIdType{ 21 } * y + x; }

  Ids nodeIds()
  {
    Ids ids;
    for (int i = 0; i < this->Traced.Contour->GetNumberOfNodes(); ++i)
    {
      ids.push_back(this->Traced.Contour->GetNthNode(i)->PointId);
    }
    return ids;
  }

  double length()
  {
    double length = 0.0;
    for (int i = 0; i < this->Traced.Contour->GetNumberOfNodes(); ++i)
    {
      length += this->Traced.lineLength(i);
    }
    return length;
  }

  void expectLines(const Lines& lines) { EXPECT_EQ(this->Traced.Interpolator->takeLines(), lines); }

  vtkSmartPointer<vtkPolyData> Surface = square(20);
  TracedContour Traced;
};

}

TEST_F(Events, PlaceDragCloseAndDelete)
{
  // Lines run between the points of the surface that are nearest to the clicks.
  this->Traced.play(click(2.1, 2.1));
  this->Traced.play(click(18.2, 1.9));
  EXPECT_EQ(this->nodeIds(), (Ids{ this->idAt(2, 2), this->idAt(18, 2) }));
  EXPECT_NEAR(this->length(), 16.0, 1e-12);
  this->expectLines({ { 0, 1 } });
  this->Traced.play(click(17.9, 18.1));
  this->expectLines({ { 1, 2 } });
  this->Traced.play(click(2.0, 18.0));
  this->expectLines({ { 2, 3 } });
  EXPECT_NEAR(this->length(), 48.0, 1e-12);
  EXPECT_FALSE(this->Traced.Contour->GetClosedLoop());
  // Beside the surface there is no node.
  this->Traced.play(click(-1.0, 10.0));
  EXPECT_EQ(this->Traced.Contour->GetNumberOfNodes(), 4);

  this->Traced.play(click(2.0, 2.0));
  EXPECT_TRUE(this->Traced.Contour->GetClosedLoop());
  EXPECT_EQ(this->Traced.Contour->GetNumberOfNodes(), 4);
  EXPECT_NEAR(this->length(), 64.0, 1e-12);
  this->Traced.Interpolator->takeLines();

  // A drag traces the two lines beside the node at each of its two moves, and nothing else.
  this->Traced.play(drag(18.0, 18.0, 14.0, 15.0));
  this->expectLines({ { 1, 2 }, { 2, 3 }, { 1, 2 }, { 2, 3 } });
  EXPECT_EQ(this->nodeIds(),
    (Ids{ this->idAt(2, 2), this->idAt(18, 2), this->idAt(14, 15), this->idAt(2, 18) }));
  EXPECT_NEAR(this->length(), 32.0 + std::hypot(4.0, 13.0) + std::hypot(12.0, 3.0), 1e-12);
  this->Traced.play(drag(2.0, 2.0, 4.0, 4.0));
  this->expectLines({ { 3, 0 }, { 0, 1 }, { 3, 0 }, { 0, 1 } });

  this->Traced.play(pressKey("Delete", 14.0, 15.0));
  EXPECT_EQ(this->nodeIds(), (Ids{ this->idAt(4, 4), this->idAt(18, 2), this->idAt(2, 18) }));
  EXPECT_TRUE(this->Traced.Contour->GetClosedLoop());
  EXPECT_NEAR(
    this->length(), std::hypot(14.0, 2.0) + std::hypot(16.0, 16.0) + std::hypot(2.0, 14.0), 1e-12);
  // A loop of two is no loop.
  this->Traced.play(pressKey("Delete", 4.0, 4.0));
  EXPECT_FALSE(this->Traced.Contour->GetClosedLoop());
  EXPECT_EQ(this->nodeIds(), (Ids{ this->idAt(18, 2), this->idAt(2, 18) }));
  EXPECT_NEAR(this->length(), std::hypot(16.0, 16.0), 1e-12);
}

// The programs' contour: z takes back one change after the other.
TEST(EventsOfPrograms, AreUndoneByKey)
{
  const auto surface = square(20);
  examples::RunOptions options;
  options.screenshot = "not written";
  examples::SurfaceWindow window("test", surface, options);
  window.interactor()->GetRenderWindow()->SetSize(400, 400);
  lookAtPlane(window.renderer());
  examples::SurfaceContour contour(window, 1, 1, 0.0);
  int changes = 0;
  contour.onChange([&] { ++changes; });
  window.interactor()->GetRenderWindow()->Render();
  const auto play = [&](const std::vector<TracedContour::Event>& events)
  { playRecording(window.interactor(), window.renderer(), events); };
  const auto id = [](int x, int y) { return vtkIdType{ 21 } * y + x; };
  const auto expectState = [&](const Ids& nodes, bool isClosed, double length)
  {
    EXPECT_EQ(contour.nodeIds(), nodes);
    EXPECT_EQ(contour.isClosed(), isClosed);
    EXPECT_NEAR(contour.length(), length, 1e-12);
  };
  const auto undo = [&] { play(pressKey("z", -1.0, -1.0)); };

  undo();
  expectState({}, false, 0.0);
  play(click(2.0, 2.0));
  play(click(18.0, 2.0));
  play(click(18.0, 14.0));
  EXPECT_EQ(changes, 3);
  play(click(2.0, 2.0));
  expectState({ id(2, 2), id(18, 2), id(18, 14) }, true, 16.0 + 12.0 + 20.0);
  play(drag(18.0, 14.0, 18.0, 10.0));
  const double dragged = 16.0 + 8.0 + std::hypot(16.0, 8.0);
  expectState({ id(2, 2), id(18, 2), id(18, 10) }, true, dragged);
  EXPECT_EQ(changes, 5);
  play(pressKey("Delete", 18.0, 2.0));
  expectState({ id(2, 2), id(18, 10) }, false, std::hypot(16.0, 8.0));

  undo();
  expectState({ id(2, 2), id(18, 2), id(18, 10) }, true, dragged);
  undo();
  expectState({ id(2, 2), id(18, 2), id(18, 14) }, true, 48.0);
  undo();
  expectState({ id(2, 2), id(18, 2), id(18, 14) }, false, 28.0);
  // What was undone can be gone on with in another way.
  play(click(10.0, 14.0));
  expectState({ id(2, 2), id(18, 2), id(18, 14), id(10, 14) }, false, 36.0);
  undo();
  undo();
  expectState({ id(2, 2), id(18, 2) }, false, 16.0);
  undo();
  expectState({ id(2, 2) }, false, 0.0);
  undo();
  expectState({}, false, 0.0);
  undo();
  expectState({}, false, 0.0);
  play(click(5.0, 5.0));
  expectState({ id(5, 5) }, false, 0.0);
}

// All nodes at once, as --seed has it.
TEST(EventsOfPrograms, AreNotNeeded)
{
  const auto surface = square(20);
  examples::RunOptions options;
  options.seeds = { 0, 20 };
  examples::SurfaceWindow window("test", surface, options);
  examples::SurfaceContour contour(window, 0, 0, 0.0);
  contour.setNodes({ 0, 20, 440 });
  EXPECT_EQ(contour.nodeIds(), (Ids{ 0, 20, 440 }));
  EXPECT_NEAR(contour.length(), 40.0, 1e-12);
  EXPECT_THROW(contour.setNodes({ 0, 441 }), std::invalid_argument);
  EXPECT_THROW(contour.setNodes({ -1 }), std::invalid_argument);
}
