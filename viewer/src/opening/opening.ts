/** The part of the page that is unpacked when somebody opens a file: three's loaders, and the core with the command line's readers. */
import './own_three';
import type { CoreFactory, CoreWithReaders } from '../core_module';
import { openEnvironment } from './environment_file';
import { openModel } from './load_model';
import type { OpeningFactory } from './opening_api';

let core: Promise<CoreWithReaders> | null = null;

const opening: OpeningFactory = (readersModule) => ({
  openModel, openEnvironment,
  readers: () => {
    const factory = (globalThis as { SturmReaders?: CoreFactory<CoreWithReaders> }).SturmReaders;
    if (!factory) throw new Error('This page was built without its readers.');
    return (core ??= factory({ wasmBinary: readersModule }));
  },
});
(globalThis as { sturmOpening?: OpeningFactory }).sturmOpening = opening;
