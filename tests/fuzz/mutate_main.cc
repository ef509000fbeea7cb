// mutate CORPUS SECONDS [SEED]: runs a fuzz target on the corpus, then on mutations of it for some
// seconds. For compilers without libFuzzer. An input that crashes the target, takes it over ten
// seconds, or makes it ask for far more memory than the input has bytes is left in the file
// "crash-<seed>".

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <new>

#include "fuzz/mutations.h"

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, size_t size);

namespace {

// What the signal handler and operator new need; neither can be given anything.
std::string g_input;
std::string g_crash_file;
size_t g_most_bytes = SIZE_MAX;  ///< of one allocation

// Decompressed data may be 88 times its input; a vector that grows doubles that.
constexpr size_t kMostGrowth = 256;
constexpr size_t kSlack = 1 << 16;

void save_input(int signal) {
  const int file = open(g_crash_file.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0644);
  if (file >= 0 && write(file, g_input.data(), g_input.size()) >= 0) close(file);
  std::fprintf(stderr, "ended by signal %d; its input is in %s\n", signal, g_crash_file.c_str());
  std::signal(signal, SIG_DFL);
  std::raise(signal);
}

void run(std::string input) {
  g_input = std::move(input);
  alarm(10);
  g_most_bytes = g_input.size() * kMostGrowth + kSlack;
  LLVMFuzzerTestOneInput(reinterpret_cast<const unsigned char*>(g_input.data()), g_input.size());
  g_most_bytes = SIZE_MAX;
  alarm(0);
}

}  // namespace

// Sanitizers report first, then abort, so that the input is saved.
extern "C" const char* __asan_default_options() {
  return "abort_on_error=1:handle_segv=2:handle_sigbus=2:handle_sigfpe=2:detect_leaks=0";
}
extern "C" const char* __ubsan_default_options() { return "abort_on_error=1:print_stacktrace=1"; }

void* operator new(size_t size) {
  if (size > g_most_bytes) {
    std::fprintf(stderr, "asks for %zu bytes with an input of %zu\n", size, g_input.size());
    std::abort();
  }
  if (void* memory = std::malloc(size == 0 ? 1 : size)) return memory;
  throw std::bad_alloc();
}
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, size_t) noexcept { std::free(memory); }

int main(int argc, char** argv) {
  if (argc < 3) {
    std::fprintf(stderr, "usage: %s CORPUS SECONDS [SEED]\n", argv[0]);
    return 2;
  }
  const double seconds = std::atof(argv[2]);
  const std::string seed = argc > 3 ? argv[3] : "1";
  g_crash_file = "crash-" + seed;
  for (const int signal : {SIGSEGV, SIGABRT, SIGALRM, SIGFPE, SIGBUS}) {
    std::signal(signal, save_input);
  }
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(argv[1])) {
    files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  std::vector<std::string> seeds;
  for (const auto& file : files) {
    std::ifstream stream(file, std::ios::binary);
    seeds.emplace_back(std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>());
    run(seeds.back());
  }
  if (seeds.empty()) {
    std::fprintf(stderr, "%s: no corpus\n", argv[1]);
    return 2;
  }
  gable::Random random(std::strtoull(seed.c_str(), nullptr, 10));
  const auto end = std::chrono::steady_clock::now() +
                   std::chrono::duration_cast<std::chrono::steady_clock::duration>(
                       std::chrono::duration<double>(seconds));
  long runs = 0;
  for (; std::chrono::steady_clock::now() < end; ++runs) run(mutated(seeds, &random));
  std::printf("%ld runs of %zu seeds\n", runs, seeds.size());
}
