// Sends raw bytes to a server on loopback, including requests that no well-behaved client makes.
#pragma once

#include <string>

namespace lippmann::test {

/// A connection, closed by the destructor.
class RawConnection {
 public:
  explicit RawConnection(int port);
  ~RawConnection();
  RawConnection(const RawConnection&) = delete;
  RawConnection& operator=(const RawConnection&) = delete;

  bool is_open() const { return socket_ >= 0; }
  void send(const std::string& bytes);
  /// Returns what arrives until the server closes the connection or sends nothing for `seconds`.
  std::string receive(double seconds = 5.0);

 private:
  int socket_ = -1;
};

/// Sends GET with Connection: close and further header lines ("Name: value\r\n"), and returns the whole answer.
std::string http_get(int port, const std::string& target, const std::string& headers = {});

/// Returns 0 without an answer.
int status_of(const std::string& answer);

}  // namespace lippmann::test
