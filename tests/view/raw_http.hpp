// Bytes to a server on loopback and back, as no well-behaved client would send them.
#pragma once

#include <string>

namespace lippmann::test {

/// A connection; closed at the end of its life.
class RawConnection {
 public:
  explicit RawConnection(int port);
  ~RawConnection();
  RawConnection(const RawConnection&) = delete;
  RawConnection& operator=(const RawConnection&) = delete;

  bool is_open() const { return socket_ >= 0; }
  void send(const std::string& bytes);
  /// Until the server closes the connection or says nothing for `seconds`.
  std::string receive(double seconds = 5.0);

 private:
  int socket_ = -1;
};

/// GET with Connection: close, and further header lines ("Name: value\r\n"). The whole answer.
std::string http_get(int port, const std::string& target, const std::string& headers = {});

/// 0 where there was no answer.
int status_of(const std::string& answer);

}  // namespace lippmann::test
