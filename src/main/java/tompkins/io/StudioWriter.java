package tompkins.io;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Predicate;
import tompkins.file.FileException;
import tompkins.file.PendingFile;
import tompkins.image.PhotographInfo;
import tompkins.ray.FileContent;
import tompkins.ray.MeshData;
import tompkins.studio.Studio;

/** Writes studios as scene files. What {@link StudioReader} makes of them is equal to the studio, to the last bit. */
public final class StudioWriter {

    private static final String A_FILE = "a file";

    /** More characters than are needed for the keys of a file inside a scene and the spaces before them. */
    private static final int LONGEST_FRAME = 1000;

    private StudioWriter() {}

    /** The text of a scene file that names its pictures and meshes; they must lie beside it when it is read. */
    static String write(Studio studio) {
        return text(studio, content -> false);
    }

    /**
     * The text of a scene file that holds its pictures and small meshes, and so can be read anywhere. It only names
     * large meshes, and all files if together they would be too long for a photograph.
     */
    public static String writeSelfContained(Studio studio) {
        return text(studio, heldInPhotographs(studio));
    }

    /** The names of the files that {@link #writeSelfContained} only names; each once. */
    public static List<String> filesOnlyNamed(Studio studio) {
        Predicate<FileContent> held = heldInPhotographs(studio);
        return contents(studio).stream()
                .filter(content -> !held.test(content))
                .map(FileContent::name)
                .distinct()
                .toList();
    }

    /** The pictures and meshes of a studio, one for each place where it has one. */
    private static List<FileContent> contents(Studio studio) {
        List<FileContent> contents = new ArrayList<>();
        members(studio, content -> {
            contents.add(content);
            return false;
        });
        return contents;
    }

    private static Predicate<FileContent> heldInPhotographs(Studio studio) {
        long length = contents(studio).stream()
                .filter(StudioWriter::isKept)
                .mapToLong(StudioWriter::lengthInside)
                .sum();
        // the text of a large scene takes long
        boolean fits = length == 0 || write(studio).length() + length <= PhotographInfo.LONGEST_SCENE;
        return content -> isKept(content) && (fits || content.name().isEmpty());
    }

    /** The names of the pictures and meshes of a studio, as scene files write them; each once. */
    public static List<String> files(Studio studio) {
        return contents(studio).stream().map(FileContent::name).distinct().toList();
    }

    /** What the meshes of a studio say in their files that is not shown. */
    public static List<String> notes(Studio studio) {
        return contents(studio).stream()
                .filter(MeshData.class::isInstance)
                .flatMap(mesh -> ((MeshData) mesh).detail().notes().stream())
                .distinct()
                .toList();
    }

    /** How much longer a text is at most for holding a file instead of naming it: four characters for three bytes. */
    private static long lengthInside(FileContent content) {
        return 4 * ((content.length() + 2L) / 3) + LONGEST_FRAME;
    }

    /** The text that {@link #save} writes to a file. */
    public static String write(Studio studio, Path file) {
        return text(studio, isToBeHeld(folderOf(file)));
    }

    /**
     * Saves a scene file. It names the pictures and meshes that lie under its folder, and holds the others. The file
     * appears complete or not at all; what was there before stays until then.
     *
     * @param replace whether it replaces the file that has its name; otherwise, if that is taken, it gets the same with
     *     a number
     * @return where it lies
     * @throws IOException with a message for the user, if the file cannot be written, or could not be read again: what
     *     cannot be held does not lie under its folder, or another file of its name does, or the text is too long for a
     *     scene file
     */
    public static Path save(Studio studio, Path file, boolean replace) throws IOException {
        byte[] text = checkedText(studio, file);
        Path place = PendingFile.save(file, replace, out -> out.write(text));
        return replace ? file : place;
    }

    /** The text of a scene file, which can be read again. */
    private static byte[] checkedText(Studio studio, Path file) throws IOException {
        SceneFolder folder = folderOf(file);
        byte[] text = text(studio, isToBeHeld(folder)).getBytes(StandardCharsets.UTF_8);
        if (text.length > SceneText.LARGEST) {
            throw new IOException(file + ": not saved: a scene file may have at most " + SceneText.LARGEST
                    + " bytes, with its pictures it would have " + text.length + "; put them into its folder first");
        }
        for (FileContent content : contents(studio)) {
            if (!isKept(content)) {
                requireIn(folder, content, file);
            }
        }
        return text;
    }

    private static SceneFolder folderOf(Path file) {
        return new SceneFolder(file.toAbsolutePath().getParent());
    }

    private static void requireIn(SceneFolder folder, FileContent content, Path file) throws IOException {
        String problem = file + ": not saved: " + content.name()
                + " cannot be held by a scene file, since it is large or has materials, and ";
        Path place = file.toAbsolutePath().getParent();
        FileContent found;
        try {
            found = folder.content(content.name(), FileKind.of(content));
        } catch (FileException ofAnotherKind) {
            found = null;
        } catch (IOException missing) {
            throw new FileException(problem + "does not lie in " + place + "; copy it there first", missing);
        }
        if (!content.equals(found)) {
            throw new FileException(problem + "another file of this name lies in " + place
                    + "; save the scene in the folder of the right one");
        }
    }

    /** What a scene file must hold: whose bytes are kept, and do not lie in its folder. */
    private static Predicate<FileContent> isToBeHeld(SceneFolder folder) {
        return content -> {
            try {
                return isKept(content) && !Arrays.equals(folder.bytes(content.name(), A_FILE), content.file());
            } catch (IOException missing) {
                return true;
            }
        };
    }

    /** Whether the bytes of the file are kept; without a name none are needed. */
    private static boolean isKept(FileContent content) {
        return content.name().isEmpty() || content.length() > 0;
    }

    private static String text(Studio studio, Predicate<FileContent> embedded) {
        return JsonLayout.text(members(studio, embedded)) + "\n";
    }

    /** The keys of a scene file, and their values. */
    private static Map<String, Object> members(Studio studio, Predicate<FileContent> embedded) {
        Map<String, Object> members = new LinkedHashMap<>();
        members.put(StudioReader.VERSION_KEY, StudioReader.VERSION);
        if (!studio.$schema().isEmpty()) {
            members.put("$schema", studio.$schema());
        }
        Object tree = new DescriptionWriter(embedded).tree(Studio.class, studio);
        ((Map<?, ?>) tree).forEach((key, value) -> members.put((String) key, value));
        return members;
    }
}
