// A self-signed certificate, made as in docs/reference/live-server.md.
import { execFileSync } from "node:child_process";
import { join } from "node:path";

/** @returns the paths of both files */
export function make_certificate(directory) {
  const [certificate, key] = [join(directory, "cert.pem"), join(directory, "key.pem")];
  const how = "req -x509 -newkey ec -pkeyopt ec_paramgen_curve:P-256 -nodes -days 1 -subj /CN=localhost";
  execFileSync("openssl", [...how.split(" "), "-keyout", key, "-out", certificate], { stdio: "ignore" });
  return { certificate, key };
}
