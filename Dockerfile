# ffgpu in a container: docker build -t ffgpu . && docker run --rm -v "$PWD:/work" ffgpu replay X.trace -o out
# The program is built and packed as `./dev package` does, and installed into a fresh Debian.
FROM debian:12 AS build
WORKDIR /source
COPY . .
RUN ./dev package

FROM debian:12
COPY --from=build /source/out/package/*.deb /tmp/
RUN apt-get update -qq \
    && apt-get install -y -qq --no-install-recommends /tmp/ffgpu_*.deb \
    && rm -rf /tmp/ffgpu_*.deb /var/lib/apt/lists/*
WORKDIR /work
ENTRYPOINT ["ffgpu"]
CMD ["--help"]
