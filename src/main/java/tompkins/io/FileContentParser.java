package tompkins.io;

import java.io.IOException;
import tompkins.image.PictureFile;
import tompkins.ray.FileContent;
import tompkins.ray.MeshData;
import tompkins.ray.PixelPicture;

/**
 * Understands one kind of file that scenes use.
 *
 * @param type what such a file holds
 * @param noun what the user calls such a file
 * @param method from the bytes and the name of a file, and the files that it may name, to what it holds
 */
record FileContentParser<T extends FileContent>(Class<T> type, String noun, Method<T> method) {

    static final FileContentParser<PixelPicture> PICTURE = new FileContentParser<>(
            PixelPicture.class, "a picture file", (file, name, others) -> PictureFile.read(file, name));

    static final FileContentParser<MeshData> MESH =
            new FileContentParser<>(MeshData.class, "an OBJ file", MeshFile::read);

    /** The parser of files that hold what another one does: a picture or a mesh. */
    static FileContentParser<?> like(FileContent content) {
        return content instanceof MeshData ? MESH : PICTURE;
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

    /** Makes what a file holds from its bytes. */
    @FunctionalInterface
    interface Method<T> {
        T read(byte[] file, String name, Files others) throws IOException;
    }

    T parse(byte[] file, String name, Files others) throws IOException {
        return method.read(file, name, others);
    }
}
