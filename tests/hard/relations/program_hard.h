// tests/hard/relations: the cases that need the program itself.
#pragma once

#include "cli/program.h"

namespace alhazen::hard {

class Hard : public cli_test::ProgramTest {
 public:
  using ProgramTest::path;
  using ProgramTest::read;
  using ProgramTest::run;
  using ProgramTest::write;
};

}  // namespace alhazen::hard
