package tompkins.io;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.Map;
import tompkins.file.FileFailure;
import tompkins.file.WholeFile;
import tompkins.ray.FileContent;

/** The files under the folder of a scene file; nothing else on the disk can be reached. Each is read once. */
final class SceneFolder {

    private final Path folder;
    private final Map<String, FileContent> read = new HashMap<>();

    SceneFolder(Path folder) {
        this.folder = folder;
    }

    /**
     * What the file with a name relative to the folder holds.
     *
     * @throws IOException with a message for the user, if the name leaves the folder or the file cannot be used
     */
    FileContent content(String name, FileKind kind) throws IOException {
        FileContent known = read.get(name);
        if (known == null || FileKind.of(known) != kind) {
            known = kind.parse(bytes(name, kind.noun()), name, this::bytes);
            read.put(name, known);
        }
        return known;
    }

    /** The bytes of a file with a name relative to the folder; the noun says what file is meant. */
    byte[] bytes(String name, String noun) throws IOException {
        Path file = find(name, noun);
        try {
            return WholeFile.read(file);
        } catch (IOException failure) {
            throw unreadable(failure);
        }
    }

    private static IOException unreadable(IOException failure) {
        return new IOException("cannot be read: " + FileFailure.reason(failure), failure);
    }

    /**
     * Where a file with a name relative to the folder lies, after links are followed; the noun says what file is meant.
     *
     * @throws IOException with a message for the user, if the name leads out of the folder, or no file that may be read
     *     has it
     */
    private Path find(String name, String noun) throws IOException {
        String allowed =
                "must be the name of " + noun + " in the folder of the scene file or below, with / between the parts";
        Path file = file(name, allowed);
        if (Files.notExists(file)) {
            throw new IOException("there is no such file in "
                    + folder.toAbsolutePath().normalize() + FileFailure.otherCase(file) + "; it " + allowed);
        }
        // links are followed first, because the place to which they lead counts
        Path real = real(file);
        if (!real.startsWith(real(folder))) {
            throw new IOException("leads out of the folder by a link; it " + allowed);
        }
        if (!Files.isRegularFile(real)) {
            throw new IOException("is not a file; it " + allowed);
        }
        return real;
    }

    private static Path real(Path path) throws IOException {
        try {
            return path.toRealPath();
        } catch (IOException failure) {
            throw unreadable(failure);
        }
    }

    private Path file(String name, String allowed) throws IOException {
        Path relative;
        try {
            relative = folder.getFileSystem().getPath(name);
        } catch (InvalidPathException impossible) {
            throw new IOException(FileFailure.reason(impossible) + "; it " + allowed, impossible);
        }
        if (name.isBlank() || relative.getRoot() != null || name.startsWith("/") || name.contains("\\")) {
            throw new IOException(allowed);
        }
        for (Path part : relative) {
            if (part.toString().equals("..")) {
                throw new IOException(allowed);
            }
        }
        return folder.resolve(relative);
    }
}
