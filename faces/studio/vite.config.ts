import { createHash } from 'node:crypto';
import { readdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { defineConfig, type Plugin } from 'vite';

const OUT = '../../build/studio';

/** Writes the service worker with the list of everything that was built. */
function serviceWorker(): Plugin {
  return {
    name: 'croquis-service-worker',
    apply: 'build',
    closeBundle() {
      const files = readdirSync(OUT, { recursive: true, withFileTypes: true })
        .filter((entry) => entry.isFile() && entry.name !== 'service-worker.js')
        .map((entry) => join(entry.parentPath ?? entry.path, entry.name));
      const hash = createHash('sha256');
      for (const file of files.sort()) hash.update(file).update(readFileSync(file));
      const list = ['./', ...files.map((file) => `./${file.slice(OUT.length + 1)}`)];
      const text = readFileSync('src/service_worker.js', 'utf8')
        .replace('__VERSION__', `croquis-${hash.digest('hex').slice(0, 16)}`)
        .replace('__FILES__', JSON.stringify(list, null, 2));
      writeFileSync(join(OUT, 'service-worker.js'), text);
    },
  };
}

export default defineConfig({
  base: './',
  esbuild: { jsx: 'automatic', jsxImportSource: 'preact' },
  worker: { format: 'es' },
  plugins: [serviceWorker()],
  build: { target: 'es2022', assetsInlineLimit: 0, outDir: OUT, emptyOutDir: true, chunkSizeWarningLimit: 1000 },
});
