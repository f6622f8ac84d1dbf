package tompkins.app;

import java.nio.file.Path;

/** A command that works with one scene file at a time. */
interface SceneCommand {

    /** The file with which it works at the moment, or null if there is no file. */
    Path scene();
}
