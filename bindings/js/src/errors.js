/** What a library could not do: `kind` is a word as "not-closed", `message` says what and where, `status` is that of C. */
export class OrbicubeError extends Error {
  constructor(status, kind, message) {
    super(message);
    this.name = 'OrbicubeError';
    this.status = status;
    this.kind = kind;
  }
}
