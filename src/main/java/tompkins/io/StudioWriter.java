package tompkins.io;

import java.io.IOException;
import java.nio.file.AtomicMoveNotSupportedException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.UUID;
import java.util.function.Predicate;
import tompkins.ray.FileContent;
import tompkins.studio.Studio;

/** Writes studios as scene files. What {@link StudioReader} makes of them is equal to the studio, to the last bit. */
public final class StudioWriter {

    private StudioWriter() {}

    /** The text of a scene file that names its pictures and meshes; they must lie beside it when it is read. */
    public static String write(Studio studio) {
        return text(studio, picture -> false);
    }

    /** The text of a scene file that holds its pictures and small meshes, and so can be read anywhere; large meshes it names. */
    public static String writeSelfContained(Studio studio) {
        return text(studio, StudioWriter::isKept);
    }

    /** The names of the files that {@link #writeSelfContained} only names, since they are too large to be held; each once. */
    public static List<String> filesOnlyNamed(Studio studio) {
        Set<String> names = new LinkedHashSet<>();
        text(studio, content -> {
            if (!isKept(content)) {
                names.add(content.name());
            }
            return false;
        });
        return List.copyOf(names);
    }

    /**
     * Saves a scene file. It names the pictures and meshes that lie under its folder, and holds the others. The file appears complete
     * or not at all; what was there before stays until then.
     *
     * @throws IOException with a message for the user, if the file cannot be written
     */
    public static void save(Studio studio, Path file) throws IOException {
        Path folder = file.toAbsolutePath().getParent();
        if (Files.isDirectory(file) || folder == null) {
            throw new IOException(file + ": cannot be written: it is a folder; name a file in it");
        }
        if (!Files.isDirectory(folder)) {
            throw new IOException(file + ": cannot be written: there is no folder " + folder);
        }
        if (Files.exists(file) && !Files.isWritable(file)) {
            throw new IOException(file + ": cannot be written: the file is write-protected");
        }
        // a link is followed: what it leads to is replaced
        Path target = Files.exists(file) ? file.toRealPath() : file.toAbsolutePath();
        Path temporary = target.resolveSibling(".tompkins-" + UUID.randomUUID() + ".part");
        try {
            Files.writeString(temporary, text(studio, isNotIn(new SceneFolder(folder))));
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

    private static Predicate<FileContent> isNotIn(SceneFolder folder) {
        return content -> {
            try {
                return isKept(content) && !Arrays.equals(folder.bytes(content.name(), "a file"), content.file());
            } catch (IOException missing) {
                return true;
            }
        };
    }

    /** Whether the bytes of the file are there; without a name none are needed. */
    private static boolean isKept(FileContent content) {
        return content.name().isEmpty() || content.file().length > 0;
    }

    private static String text(Studio studio, Predicate<FileContent> embedded) {
        Map<String, Object> members = new LinkedHashMap<>();
        members.put(StudioReader.VERSION_KEY, StudioReader.VERSION);
        Object tree = new DescriptionWriter(embedded).tree(Studio.class, studio);
        ((Map<?, ?>) tree).forEach((key, value) -> members.put((String) key, value));
        return JsonLayout.text(members) + "\n";
    }
}
