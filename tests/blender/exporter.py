"""A Blender that stays open and exports the scenes of all tests in a file, because starting Blender takes longer than a small
export.

serve() starts this server. Each export then runs this file as a client, which sends its request to the server. Exports that may
run scripts still start a new Blender, because only a command-line flag can allow scripts.
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
    """Starts the server and redirects exports to it. jobs: the module lippmann.job."""
    import bpy  # the client runs without Blender

    folder = tempfile.mkdtemp(prefix="lippmann-exporter-")
    address = os.path.join(folder, "socket")
    listener = socket.socket(socket.AF_UNIX)
    listener.bind(address)
    listener.listen()
    words = [bpy.app.binary_path, "-b", "--factory-startup", "-noaudio", "--disable-autoexec", "-P", str(HERE), "--", str(listener.fileno())]
    # Closing the pipe to stdin ends the server, even if this process crashes.
    server = subprocess.Popen(words, stdin=subprocess.PIPE, stdout=subprocess.DEVNULL, pass_fds=[listener.fileno()])
    listener.close()
    own = jobs.Job._export_words

    def export_words(job):
        return own(job) if jobs.scripts_are_allowed() else ["python3", "-I", "-S", str(HERE), address, str(job._request)]

    jobs.Job._export_words = export_words
    atexit.register(end, server, folder)


def end(server, folder):
    server.communicate()
    shutil.rmtree(folder)


def ask(address, request):
    """Sends a request and this process's stdout and stderr to the server. Returns the exit code of the export."""
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
    except Exception as error:
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
    lippmann.register = lambda: None  # each export calls register() again
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
