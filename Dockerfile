# README.md's two commands in a clean Debian 12:
#   docker build -t lippmann .           the first: builds the tool and renders the demo
#   docker build --target test .         the second, too: all tests
#   buildah bud --isolation chroot --target demo -t lippmann .   the first without a daemon
#   docker run --rm -v "$PWD:/work" -w /work lippmann render room --frames 0
FROM debian:12 AS demo
WORKDIR /lippmann
COPY . .
RUN scripts/demo
ENTRYPOINT ["/lippmann/build/release/lippmann"]

FROM demo AS test
RUN scripts/test

# What is built where no stage is named.
FROM demo
