#pragma once

#include <isostretch/baselines/result.hpp>

#include <string>
#include <vector>

namespace isostretch::baselines {

// What a program for semidefinite programs says of min c^T v, sum_k v_k A_k - A_0 >= 0.
struct SdpAnswer {
  Status status = Status::not_run;  // not_run: it says nothing about how it ended
  std::string message;              // the line that tells
  int iterations = 0;
  std::vector<double> v;  // as many numbers as could be read, in a row
};

// From what the program printed and the file that it left. They never throw: what is not there is not in the
// answer.
SdpAnswer read_csdp(const std::string& output, const std::string& answer);
SdpAnswer read_sdpa(const std::string& output, const std::string& answer);
SdpAnswer read_dsdp(const std::string& output, const std::string& answer);

// The last line that is not empty.
std::string last_line(const std::string& text);
// Whether it has one of the words in which programs, and the C++ library, say that there is no more.
bool speaks_of_memory(const std::string& text);

}  // namespace isostretch::baselines
