"""A proxy of this machine that refuses all requests, and keeps what they asked for."""
import http.server
import threading


class CountingProxy:
    def __init__(self):
        self.asked = []  # addresses, as they came: http://host/path, or host:port of a connection
        asked = self.asked

        class Refuser(http.server.BaseHTTPRequestHandler):
            def refuse(self):
                asked.append(self.path)
                self.send_error(403)

            do_GET = do_POST = do_HEAD = do_PUT = do_OPTIONS = do_CONNECT = refuse

            def log_message(self, *words):
                pass

        self.server = http.server.ThreadingHTTPServer(("127.0.0.1", 0), Refuser)
        self.port = self.server.server_address[1]
        self.thread = threading.Thread(target=self.server.serve_forever, daemon=True)
        self.thread.start()

    def close(self):
        self.server.shutdown()
        self.server.server_close()
        self.thread.join()
