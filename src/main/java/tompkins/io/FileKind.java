package tompkins.io;

import java.io.IOException;
import tompkins.image.PictureFile;
import tompkins.ray.FileContent;
import tompkins.ray.MeshData;

/** The kinds of files that scenes use. */
enum FileKind {
    PICTURE("a picture file"),
    MESH("an OBJ file");

    private final String noun;

    FileKind(String noun) {
        this.noun = noun;
    }

    /** The kind of the files that hold what another one does. */
    static FileKind of(FileContent content) {
        return content instanceof MeshData ? MESH : PICTURE;
    }

    /** What the user calls such a file. */
    String noun() {
        return noun;
    }

    /** Makes what a file holds from its bytes and its name, and the files that it may name. */
    FileContent parse(byte[] file, String name, Files others) throws IOException {
        return this == MESH ? MeshFile.read(file, name, others) : PictureFile.read(file, name);
    }

    /** The files that a file may name, as seen from the folder of the scene. */
    @FunctionalInterface
    interface Files {

        /** There are none. */
        Files NONE = (name, noun) -> {
            throw new IOException("it does not travel inside a photograph");
        };

        /**
         * The bytes of a file.
         *
         * @param noun says what file is meant
         * @throws IOException with a message for the user, if there is none that may be read
         */
        byte[] bytes(String name, String noun) throws IOException;
    }
}
