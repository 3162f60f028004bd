"""One Blender that exports the scenes of a whole test file: starting a Blender takes longer than exporting a small scene.

serve() begins it and lets jobs call it, through a small client in place of a new Blender; both run this file. A request that allows scripts still gets a Blender
of its own, since that is decided when Blender starts.
"""

import atexit
import os
import pathlib
import shutil
import socket
import subprocess
import sys
import tempfile
import threading
import traceback

HERE = pathlib.Path(__file__).resolve()


def serve(jobs):
    """Exports through one Blender from now on. jobs: the module lippmann.job."""
    import bpy  # the client has none

    folder = tempfile.mkdtemp(prefix="lippmann-exporter-")
    address = os.path.join(folder, "socket")
    listener = socket.socket(socket.AF_UNIX)
    listener.bind(address)
    listener.listen()
    words = [bpy.app.binary_path, "-b", "--factory-startup", "-noaudio", "--disable-autoexec", "-P", str(HERE), "--", str(listener.fileno())]
    # The server also ends when this process crashes, which closes the pipe.
    server = subprocess.Popen(words, stdin=subprocess.PIPE, stdout=subprocess.DEVNULL, pass_fds=[listener.fileno()])
    listener.close()
    own = jobs.Job._export_words

    def export_words(job):
        return own(job) if jobs.scripts_are_allowed() else ["python3", "-I", "-S", str(HERE), address, str(job._request)]

    jobs.Job._export_words = export_words
    atexit.register(end, server, folder)


def end(server, folder):
    server.communicate()  # closes its stdin
    shutil.rmtree(folder)


def ask(address, request):
    """The client: hands its request, stdout and stderr to the server. Returns the exit code."""
    with socket.socket(socket.AF_UNIX) as server:
        server.connect(address)
        socket.send_fds(server, [request.encode()], [1, 2])
        code = server.recv(1)
    return code[0] if code else 1


def end_with_parent():
    sys.stdin.read()
    os._exit(0)


def export(main, request):
    sys.argv[sys.argv.index("--") + 1:] = [request]
    try:
        main()
    except Exception as error:  # as scene_export.py does where it is a program
        print(f"error: {error}", file=sys.stderr)
        traceback.print_exc()
        return 1
    return 0


def answer(main, connection):
    request, descriptors, *_ = socket.recv_fds(connection, 65536, 2)
    own = [os.dup(number) for number in (1, 2)]
    for number, lent in zip((1, 2), descriptors):
        os.dup2(lent, number)
    code = export(main, request.decode())
    sys.stdout.flush(), sys.stderr.flush()
    for number, kept in zip((1, 2), own):
        os.dup2(kept, number)
    for number in (*own, *descriptors):
        os.close(number)
    connection.send(bytes([code]))


def run_server(listener):
    sys.path.insert(0, str(HERE.parents[2] / "blender"))
    import lippmann
    from lippmann import scene_export

    lippmann.register()
    lippmann.register = lambda: None  # what each export calls
    threading.Thread(target=end_with_parent, daemon=True).start()
    while True:
        connection, _ = listener.accept()
        with connection:
            answer(scene_export.main, connection)


if __name__ == "__main__":
    if "--" in sys.argv:
        run_server(socket.socket(fileno=int(sys.argv[sys.argv.index("--") + 1])))
    else:
        sys.exit(ask(*sys.argv[1:]))
