package tompkins.io;

import java.io.IOException;
import java.nio.file.AtomicMoveNotSupportedException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.UUID;
import java.util.function.Predicate;
import tompkins.ray.PixelPicture;
import tompkins.studio.Studio;

/** Writes studios as scene files. What {@link StudioReader} makes of them is equal to the studio, to the last bit. */
public final class StudioWriter {

    private StudioWriter() {}

    /** The text of a scene file that names its pictures; they must lie beside it when it is read. */
    public static String write(Studio studio) {
        return text(studio, picture -> false);
    }

    /** The text of a scene file that holds its pictures, and so can be read anywhere. */
    public static String writeSelfContained(Studio studio) {
        return text(studio, picture -> true);
    }

    /**
     * Saves a scene file. It names the pictures that lie under its folder, and holds the others. The file appears complete
     * or not at all; what was there before stays until then.
     *
     * @throws IOException with a message for the user, if the file cannot be written
     */
    public static void save(Studio studio, Path file) throws IOException {
        Path folder = file.toAbsolutePath().getParent();
        if (Files.isDirectory(file) || folder == null) {
            throw new IOException(file + ": cannot be written: it is a folder; name a file in it");
        }
        if (Files.exists(file) && !Files.isWritable(file)) {
            throw new IOException(file + ": cannot be written: the file is write-protected");
        }
        // a link is followed: what it leads to is replaced
        Path target = Files.exists(file) ? file.toRealPath() : file.toAbsolutePath();
        Path temporary = target.resolveSibling(".tompkins-" + UUID.randomUUID() + ".part");
        try {
            Files.writeString(temporary, text(studio, isNotIn(new PictureFolder(folder))));
            move(temporary, target);
        } catch (IOException failure) {
            throw new IOException(file + ": cannot be written: " + FileFailure.reason(failure), failure);
        } finally {
            Files.deleteIfExists(temporary);
        }
    }

    private static void move(Path from, Path to) throws IOException {
        try {
            Files.move(from, to, StandardCopyOption.ATOMIC_MOVE);
        } catch (AtomicMoveNotSupportedException perhapsAnotherDisk) {
            Files.move(from, to, StandardCopyOption.REPLACE_EXISTING);
        }
    }

    private static Predicate<PixelPicture> isNotIn(PictureFolder folder) {
        return picture -> {
            try {
                return !Arrays.equals(folder.bytes(picture.name()), picture.file());
            } catch (IOException missing) {
                return true;
            }
        };
    }

    private static String text(Studio studio, Predicate<PixelPicture> embedded) {
        Map<String, Object> members = new LinkedHashMap<>();
        members.put(StudioReader.VERSION_KEY, StudioReader.VERSION);
        Object tree = new DescriptionWriter(embedded).tree(Studio.class, studio);
        ((Map<?, ?>) tree).forEach((key, value) -> members.put((String) key, value));
        return JsonLayout.text(members) + "\n";
    }
}
