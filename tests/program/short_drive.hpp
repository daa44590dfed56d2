#pragma once

#include "workplace.hpp"

namespace aisle {

/// A workplace with the keys of a drive of three seconds, and the commands to drive them.
class WorkplaceWithKeys : public Workplace {
 protected:
  void SetUp() override { file("keys.txt", "0-2 up\n1 place lobby\n2-2.5 left\n"); }

  /// The mini-vehicle in its corridor by the keys, with its camera.
  Arguments drive(const std::string& out, const Arguments& more = {}) const {
    Arguments arguments = {"drive",        "mini-corridor", "--vehicle", "mini",  "--keys",
                           at("keys.txt"), "--out",         at(out),     "--json"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return arguments;
  }
};

/// A workplace with the session of that drive, without images.
class WorkplaceWithSession : public WorkplaceWithKeys {
 protected:
  void SetUp() override {
    WorkplaceWithKeys::SetUp();
    const ProgramRun run = run_aisle(drive("drive", {"--no-images"}));
    ASSERT_EQ(run.exit_code, 0) << run.err;
  }

  std::string session() const { return at("drive"); }
  std::string database() const { return at("drive/drive_0.db3"); }
};

}  // namespace aisle
