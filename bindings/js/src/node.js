/** A module of node's own. Bundlers for pages, where it is not used, do not resolve a name that is computed. */
export const ofNode = (name) => import(/* webpackIgnore: true */ /* @vite-ignore */ `node:${name}`);
