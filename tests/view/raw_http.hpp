// Sends bytes to a server on the loopback address. The bytes may be requests that ordinary clients never send.
#pragma once

#include <string>

namespace lippmann::test {

/// A connection to the server. The destructor closes it.
class RawConnection {
 public:
  explicit RawConnection(int port);
  ~RawConnection();
  RawConnection(const RawConnection&) = delete;
  RawConnection& operator=(const RawConnection&) = delete;

  bool is_open() const { return socket_ >= 0; }
  void send(const std::string& bytes);
  /// Returns the received bytes. Returns when the server closes the connection, or when it has sent nothing for `seconds`.
  std::string receive(double seconds = 5.0);

 private:
  int socket_ = -1;
};

/// Sends a GET request with "Connection: close", and returns the whole answer. `headers` are further header lines, each ended
/// by CR LF.
std::string http_get(int port, const std::string& target, const std::string& headers = {});

/// Returns the status code of an HTTP answer, or 0 if the answer is empty.
int status_of(const std::string& answer);

}  // namespace lippmann::test
