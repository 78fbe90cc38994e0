#pragma once

#include <filesystem>

namespace sonoskin {

// availableProcessors: how many processors the system lets this process use at once; 1 or more.
//   method   those it may run on (affinity), and of these as many as its control groups pay for, rounded up
int availableProcessors();

// quotaOfGroups: processors that control groups pay for; a very large number where none is limited.
//   method   the least of cpu.max, or cpu.cfs_quota_us over cpu.cfs_period_us, of the process' own group and those above it
//   input    groups   what /proc/self/cgroup says
//            root     where groups are mounted, as /sys/fs/cgroup
double quotaOfGroups(const std::filesystem::path& groups, const std::filesystem::path& root);

}  // namespace sonoskin
