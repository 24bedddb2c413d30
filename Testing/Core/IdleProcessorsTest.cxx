// SPDX-FileCopyrightText: SurfaceGeodesics authors
// SPDX-License-Identifier: BSD-3-Clause
#include "base/IdleProcessors.h"

#include <gtest/gtest.h>

#include <sstream>
#include <string>

using namespace geodesic;

namespace
{

unsigned idleOf(unsigned processors, const std::string& load)
{
  std::istringstream stream(load);
  return idleProcessors(processors, stream);
}

}

TEST(IdleProcessors, AreThoseWithoutOtherThreads)
{
  EXPECT_EQ(idleOf(8, "0.62 2.10 2.61 1/81 17674"), 8);
  EXPECT_EQ(idleOf(8, "0.62 2.10 2.61 4/81 17674"), 5);
  EXPECT_EQ(idleOf(2, "0.62 2.10 2.61 2/81 17674"), 1);
  // The calling thread has one in any case.
  EXPECT_EQ(idleOf(2, "9.62 9.10 9.61 99/810 17674"), 1);
}

TEST(IdleProcessors, AreAllWhereNothingIsKnown)
{
  EXPECT_EQ(idleOf(4, ""), 4);
  EXPECT_EQ(idleOf(4, "no numbers here"), 4);
  EXPECT_EQ(idleOf(4, "0.62 2.10 2.61 0/81 17674"), 4);
  EXPECT_GE(idleProcessors(), 1);
}
