#include "simulation/world.hpp"

#include <cxxabi.h>
#include <fmt/core.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <utility>

namespace lippmann::test {
namespace {

constexpr std::size_t kStackBytes = std::size_t{1} << 20;
constexpr std::int64_t kSecond = 1'000'000'000;

/// New processes reuse the stacks of ended ones.
std::vector<std::unique_ptr<std::byte[]>>& free_stacks() {
  static std::vector<std::unique_ptr<std::byte[]>> stacks;
  return stacks;
}

std::unique_ptr<std::byte[]> take_stack() {
  auto& stacks = free_stacks();
  if (stacks.empty()) return std::unique_ptr<std::byte[]>(new std::byte[kStackBytes]);
  auto stack = std::move(stacks.back());
  stacks.pop_back();
  return stack;
}

}  // namespace

World*& world() {
  static World* current = nullptr;
  return current;
}

World::World(std::uint64_t seed, int machines, bool share_a_name)
    : random(seed), clocks_(static_cast<std::size_t>(machines), 1'700'000'000 * kSecond), share_a_name_(share_a_name) {
  disk.make_folder("/sim");
  disk.sync(0);
  world() = this;
}

World::~World() { world() = nullptr; }

std::string World::machine_name(int machine) const { return share_a_name_ ? "node" : fmt::format("node{}", machine); }

bool World::is_alive(int machine, int pid) const {
  return std::any_of(processes_.begin(), processes_.end(), [&](const auto& process) {
    return process->machine == machine && process->pid == pid && !process->is_dead;
  });
}

std::int64_t World::nanoseconds(int machine) const {
  return clocks_[static_cast<std::size_t>(machine)] + static_cast<std::int64_t>(steps) * 1'000'000;
}

void World::pass(std::int64_t nanoseconds) {
  for (std::int64_t& clock : clocks_) clock += nanoseconds;
}

void World::enter() {
  Process& self = *world()->current_;
  self.body();
  self.has_ended = true;
  _longjmp(world()->scheduler_, 1);
}

/// longjmp needs no system call; swapcontext would make two.
void World::go_to(Process& process) {
  if (_setjmp(scheduler_) != 0) return;
  if (process.has_begun) _longjmp(process.place, 1);
  process.has_begun = true;
  setcontext(&process.context);
}

void World::let_others_go_on() {
  const int own_error = errno;
  if (_setjmp(current_->place) == 0) _longjmp(scheduler_, 1);
  errno = own_error;
}

Process& World::start(int machine, std::function<void()> body) {
  auto process = std::make_unique<Process>();
  process->id = ++next_id_, process->machine = machine, process->began = steps;
  do process->pid = 1 + static_cast<int>(random.below(share_a_name_ ? 4 : 30000));
  while (is_alive(machine, process->pid));
  process->body = std::move(body);
  process->stack = take_stack();
  getcontext(&process->context);
  process->context.uc_stack.ss_sp = process->stack.get();
  process->context.uc_stack.ss_size = kStackBytes;
  process->context.uc_link = nullptr;
  makecontext(&process->context, &World::enter, 0);
  processes_.push_back(std::move(process));
  return *processes_.back();
}

void World::resume(Process& process) {
  void* exceptions = abi::__cxa_get_globals();
  std::array<std::byte, 16> own{};
  std::memcpy(own.data(), exceptions, own.size());
  std::memcpy(exceptions, process.exceptions.data(), own.size());
  current_ = &process;
  go_to(process);
  current_ = nullptr;
  std::memcpy(process.exceptions.data(), exceptions, own.size());
  std::memcpy(exceptions, own.data(), own.size());
}

void World::run(const std::function<void()>& ready) {
  for (;;) {
    if (ready) ready();
    if (processes_.empty()) return;
    Process& process = *processes_[random.below(processes_.size())];
    resume(process);
    if (process.is_dead)
      while (!process.has_ended) resume(process);
    std::erase_if(processes_, [](auto& ended) {
      if (ended->has_ended) free_stacks().push_back(std::move(ended->stack));
      return ended->has_ended;
    });
    happen();
  }
}

void World::kill_some(int machine) {
  for (const auto& process : processes_)
    if (machine < 0 || process->machine == machine) process->is_dead = true;
}

void World::flip_a_byte() {
  for (int tries = 0; tries < 4; ++tries) {
    std::string path = "/sim";
    int inode = disk.find(path);
    while (disk.at(inode).is_folder && !disk.at(inode).entries.empty()) {
      auto entry = disk.at(inode).entries.begin();
      std::advance(entry, static_cast<std::ptrdiff_t>(random.below(disk.at(inode).entries.size())));
      path += '/' + entry->first, inode = entry->second;
    }
    Inode& file = disk.at(inode);
    if (file.is_folder || file.bytes.empty() || !flips || !flips(path)) continue;
    const std::size_t at = random.below(file.bytes.size());
    file.bytes[at] = static_cast<char>(file.bytes[at] ^ 0x20);
    file.safe = file.bytes;
    last_flip = steps;
    log += fmt::format("{}: a byte of {} is flipped\n", steps, path);
    return;
  }
}

void World::happen() {
  if (!processes_.empty() && random.once_in(faults.kill)) {
    Process& process = *processes_[random.below(processes_.size())];
    process.is_dead = true;
    log += fmt::format("{}: process {} is killed\n", steps, process.id);
  }
  if (random.once_in(faults.machine_loss)) {
    const auto machine = static_cast<int>(random.below(clocks_.size()));
    log += fmt::format("{}: machine {} is gone\n", steps, machine);
    kill_some(machine);
    disk.lose_machine(machine, random);
  }
  if (random.once_in(faults.power_loss)) {
    log += fmt::format("{}: power is gone\n", steps);
    kill_some(-1);
    disk.lose_power(random);
  }
  if (random.once_in(faults.disk_full)) {
    full_until_ = steps + random.below(300);
    log += fmt::format("{}: the disk is full until {}\n", steps, full_until_);
  }
  if (random.once_in(faults.clock_jump)) {
    const std::int64_t years = kSecond * 31'000'000;
    clocks_[random.below(clocks_.size())] +=
        (random.once_in(2) ? 1 : -1) * static_cast<std::int64_t>(random.below(static_cast<std::size_t>(years)));
    log += fmt::format("{}: a clock is set\n", steps);
  }
  if (random.once_in(faults.flipped_byte)) flip_a_byte();
}

int World::before(Call call) {
  if (!current_) return 0;
  if (!current_->is_dead && random.once_in(2)) let_others_go_on();
  if (current_->is_dead) return EIO;
  ++steps;
  if (call == Call::kRead && random.once_in(faults.read_error)) {
    current_->has_misread = true;
    log += fmt::format("{}: a read of process {} fails\n", steps, current_->id);
    return EIO;
  }
  if (call != Call::kWrite) return 0;
  if (steps < full_until_) return ENOSPC;
  if (!random.once_in(faults.error)) return 0;
  log += fmt::format("{}: a call of process {} fails\n", steps, current_->id);
  return random.once_in(2) ? EIO : ENOSPC;
}

std::size_t World::moved(std::size_t bytes) {
  if (!current_ || bytes == 0 || !random.once_in(faults.interrupted)) return bytes;
  return 1 + random.below(bytes);
}

}  // namespace lippmann::test
