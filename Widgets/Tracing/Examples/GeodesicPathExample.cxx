// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
// Traces a contour on a surface: places nodes one by one and joins them by shortest paths.

#include "SurfaceContour.h"
#include "SurfaceFile.h"

#include <cstdlib>
#include <exception>
#include <iostream>

using namespace geodesic::examples;

namespace
{

constexpr const char* usage =
  "usage: GeodesicPathExample mesh.vtp [method] [order] [heightOffset] [options]\n"
  "  method        0: Dijkstra's algorithm along edges (default), 1: fast marching\n"
  "  order         0: through points of the mesh (default), 1: across faces; method 1 only\n"
  "  heightOffset  raises the path, in the mesh's unit of length (default: 0)\n"
  "\n"
  "Click to place a node. Click at the first node to close the contour, or press the\n"
  "right button to place the last one. Then drag nodes, delete the one under the\n"
  "pointer with Delete, or click on the path for one more. z takes back the last change.\n"
  "Drag beside the surface to turn it; q quits.\n";

/** @throws std::invalid_argument if the text is neither 0 nor 1 */
int choiceIn(const std::string& text, const std::string& name)
{
  if (text != "0" && text != "1")
  {
    throw std::invalid_argument(name + " is \"" + text + "\"; it must be 0 or 1.");
  }
  return text == "1" ? 1 : 0;
}

void print(const SurfaceContour& contour)
{
  std::cout << "nodes";
  for (vtkIdType id : contour.nodeIds())
  {
    std::cout << " " << id;
  }
  std::cout << (contour.isClosed() ? ", closed" : ", open") << ", length " << contour.length()
            << std::endl;
}

int run(int argc, char* argv[])
{
  Arguments arguments(usage);
  if (!arguments.parse(argc, argv, 1, 4))
  {
    return EXIT_SUCCESS;
  }
  const std::vector<std::string>& given = arguments.positional();
  const RunOptions options = arguments.runOptions();
  const int method = given.size() > 1 ? choiceIn(given[1], "The method") : 0;
  const int order = given.size() > 2 ? choiceIn(given[2], "The order") : 0;
  const double heightOffset = given.size() > 3 ? numberIn(given[3], "The height offset") : 0.0;
  if (order == 1 && method == 0)
  {
    throw std::invalid_argument("Dijkstra's paths (method 0) are of order 0; give method 1.");
  }

  SurfaceWindow window("Geodesic path", readSurface(given[0]), options);
  SurfaceContour contour(window, method, order, heightOffset);
  contour.onChange([&] { print(contour); });
  if (!options.seeds.empty())
  {
    contour.setNodes(options.seeds);
    print(contour);
  }
  window.run();
  window.writeScreenshot();
  return EXIT_SUCCESS;
}

}

int main(int argc, char* argv[])
{
  try
  {
    return run(argc, argv);
  }
  catch (const std::exception& error)
  {
    std::cerr << "GeodesicPathExample: " << error.what() << " See --help." << std::endl;
    return EXIT_FAILURE;
  }
}
