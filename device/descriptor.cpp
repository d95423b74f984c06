// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/descriptor.h"

#include <unistd.h>

namespace dgt {

void Descriptor::close() {
  if (fd_ >= 0) ::close(std::exchange(fd_, -1));
}

}  // namespace dgt
