package tompkins.io;

import java.nio.file.Path;
import java.util.List;
import tompkins.io.JsonValue.JsonNumber;
import tompkins.io.JsonValue.JsonObject;
import tompkins.io.JsonValue.Member;
import tompkins.studio.Studio;

/** Reads studios from scene files and from saved photographs. */
public final class StudioReader {

    /** The version of the format. */
    static final int VERSION = 1;

    static final String VERSION_KEY = "version";

    private StudioReader() {}

    /**
     * Reads a scene file, or the scene that a saved photograph holds.
     *
     * @throws SceneFileException if the file cannot be read, or there are mistakes in it
     */
    public static Studio read(Path file) {
        Problems problems = new Problems(file.toString());
        String text = new SceneText(file, problems).read();
        return studio(text, problems, file.toAbsolutePath().getParent());
    }

    /**
     * Reads the text of a scene file.
     *
     * @param name the name of the file, for messages
     * @param folder where the scene's pictures and meshes are
     * @throws SceneFileException if there are mistakes in the text
     */
    public static Studio read(String text, String name, Path folder) {
        return studio(text, new Problems(name), folder);
    }

    private static Studio studio(String text, Problems problems, Path folder) {
        JsonObject root = JsonParsing.parse(text, problems);
        Member version = root.members().get(VERSION_KEY);
        if (version != null && !isKnown(version.value())) {
            String shown = version.value().shown();
            problems.add(
                    version.value(), VERSION_KEY, "must be " + VERSION + ", the only one that there is, was " + shown);
            throw problems.exception();
        }
        DescriptionReader reader = new DescriptionReader(problems, new SceneFolder(folder));
        Object studio = reader.record(Studio.class, root, "", List.of(VERSION_KEY));
        if (!problems.isEmpty()) {
            throw problems.exception();
        }
        return (Studio) studio;
    }

    private static boolean isKnown(JsonValue version) {
        return version instanceof JsonNumber number && number.text().equals(Integer.toString(VERSION));
    }
}
