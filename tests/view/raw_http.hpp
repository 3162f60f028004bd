// Sends any bytes to a server on the loopback address.
#pragma once

#include <string>

namespace lippmann::test {

class RawConnection {
 public:
  explicit RawConnection(int port);
  ~RawConnection();
  RawConnection(const RawConnection&) = delete;
  RawConnection& operator=(const RawConnection&) = delete;

  bool is_open() const { return socket_ >= 0; }
  void send(const std::string& bytes);
  /// Receives until the server closes the connection, or has sent nothing for `seconds`.
  std::string receive(double seconds = 5.0);

 private:
  int socket_ = -1;
};

std::string http_get(int port, const std::string& target, const std::string& headers = {});

int status_of(const std::string& answer);

}  // namespace lippmann::test
