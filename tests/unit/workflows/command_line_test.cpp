#include "md/error.hpp"
#include "workflows/command/list.hpp"
#include "workflows/command_line.hpp"
#include "workflows/interrupt.hpp"
#include "workflows/nearest.hpp"
#include <CLI/CLI.hpp>
#include <csignal>
#include <gtest/gtest.h>
#include <set>
#include <spdlog/logger.h>

namespace mesobridge::workflows {

namespace {

Command failing_command(std::string name, std::function<void()> fail) {
  return {.name = std::move(name),
          .summary = "fails",
          .example = "mesobridge fail",
          .declare = [fail](CLI::App& app) {
            app.add_option_function<std::string>("--model", [](std::string const&) {})->required();
            return [fail](Context&) {
              fail();
              return Result{};
            };
          }};
}

struct Outcome {
  int code;
  std::string output, errors;
};

Outcome run(std::vector<std::string> const& arguments, std::vector<Command> const& commands) {
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  int const code = run_command_line(arguments, commands);
  auto output = testing::internal::GetCapturedStdout();
  return {code, output, testing::internal::GetCapturedStderr()};
}

TEST(Commands, AreListedOnceEach) {
  std::set<std::string> names;
  for (auto const& command : commands())
    EXPECT_TRUE(names.insert(command.name).second) << command.name;
  EXPECT_GT(names.size(), 30u);
}

TEST(CommandLine, ExceptionsBecomeExitCodes) {
  struct Case {
    int code;
    std::function<void()> fail;
    std::string message;
  };
  std::vector<Case> const cases{
      {2, [] { throw InputError("no such key"); }, "no such key"},
      {3, [] { throw PhysicsError("unstable at step 7"); }, "unstable at step 7"},
      {4, [] { throw EnvironmentError("disk full"); }, "disk full"},
      {4, [] { throw std::bad_alloc(); }, "not enough memory"},
      {4, [] { throw std::logic_error("a slip"); }, "unexpected failure: a slip"},
      {4, [] { throw 42; }, "unexpected failure"},
      {130, [] { throw Interrupted("interrupted"); }, "interrupted"},
      {130, [] { throw_if_interrupted(), std::raise(SIGINT), throw_if_interrupted(); },
       "what was written stays"},
      {130, [] { throw_if_interrupted(), std::raise(SIGTERM), throw_if_interrupted(); }, "SIGTERM"},
      {0, [] { throw_if_interrupted(); }, ""},
  };
  int ran = 0;
  for (auto const& [code, fail, message] : cases) {
    auto const outcome = run({"fail", "--model", "x"}, {failing_command("fail", fail)});
    EXPECT_EQ(outcome.code, code);
    EXPECT_NE(outcome.errors.find(message), std::string::npos) << outcome.errors;
    EXPECT_EQ(std::count(outcome.errors.begin(), outcome.errors.end(), '\n'), code == 0 ? 0 : 1);
    EXPECT_EQ(outcome.output, "");
    ++ran;
  }
  EXPECT_EQ(ran, 10);
}

TEST(CommandLine, MisspellingsNameTheNearest) {
  std::vector<Command> const commands{failing_command("md lj-grid", [] {}), failing_command("check", [] {})};
  std::vector<std::pair<std::vector<std::string>, std::string>> const cases{
      {{"chekc"}, "unknown command 'chekc'; did you mean 'check'?"},
      {{"md", "lj-gird"}, "unknown command 'md lj-gird'; did you mean 'md lj-grid'?"},
      {{"md"}, "'md' needs one of: md lj-grid"},
      {{"banana"}, "unknown command 'banana'; `mesobridge --help` lists them all"},
      {{"check", "--modle", "x"}, "check: unknown option '--modle'; did you mean '--model'?"},
      {{"check", "--modle=x"}, "check: unknown option '--modle'; did you mean '--model'?"},
      {{"check", "--model", "x", "--quite"}, "unknown option '--quite'; did you mean '--quiet'?"},
      {{"check", "--model", "x", "extra"}, "check: unexpected argument 'extra'"},
      {{"check"}, "check: --model is required"},
      {{"check", "--model", "x", "--threads", "0"}, "--threads: Value 0 not in range"},
      {{"check", "--model", "x", "--seed", "-1"}, "--seed"},
      {{"--json", "check"}, "the command comes first"},
  };
  int ran = 0;
  for (auto const& [arguments, message] : cases) {
    auto const outcome = run(arguments, commands);
    EXPECT_EQ(outcome.code, 2);
    EXPECT_NE(outcome.errors.find(message), std::string::npos) << outcome.errors;
    ++ran;
  }
  EXPECT_EQ(ran, 12);
}

TEST(CommandLine, JsonIsOneObjectAndNeverHoldsANaN) {
  auto const command = [](Result result) {
    return Command{.name = "give", .summary = "", .example = "", .declare = [result](CLI::App&) {
                     return [result](Context& context) {
                       context.log->info("a message");
                       return result;
                     };
                   }};
  };
  Result result{.json = {{"P_Pa", 1.5}}, .text = "P = 1.5 Pa", .complaint = ""};
  auto const json = run({"give", "--json"}, {command(result)});
  EXPECT_EQ(Json::parse(json.output)["P_Pa"], 1.5);
  auto const text = run({"give"}, {command(result)});
  EXPECT_EQ(text.output, "P = 1.5 Pa\n");

  result.json["states"] = {{{"T_K", std::nan("")}}};
  auto const refused = run({"give", "--json"}, {command(result)});
  EXPECT_EQ(refused.code, 3);
  EXPECT_EQ(refused.output, "");
  EXPECT_NE(refused.errors.find("states[0].T_K"), std::string::npos) << refused.errors;
}

TEST(Nearest, FindsMisspellingsOnly) {
  std::vector<std::string> const keys{"rho", "eta", "zeta", "equilibrate", "sample_every"};
  EXPECT_EQ(nearest("equilbrate", keys), "equilibrate");
  EXPECT_EQ(nearest("samples_every", keys), "sample_every");
  EXPECT_EQ(nearest("rhp", keys), "rho");
  EXPECT_EQ(nearest("hro", keys), "rho"); // one swap
  EXPECT_EQ(nearest("temperature", keys), "");
  EXPECT_EQ(nearest("", keys), "");
}

} // namespace

} // namespace mesobridge::workflows
