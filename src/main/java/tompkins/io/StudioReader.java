package tompkins.io;

import java.nio.file.Path;
import java.util.List;
import java.util.function.Supplier;
import tompkins.io.JsonValue.JsonList;
import tompkins.io.JsonValue.JsonNumber;
import tompkins.io.JsonValue.JsonObject;
import tompkins.io.JsonValue.Member;
import tompkins.property.InvalidPropertyException;
import tompkins.property.MistakeException;
import tompkins.studio.Studio;
import tompkins.studio.StudioPath;

/** Reads studios from scene files and from saved photographs. */
public final class StudioReader {

    /** The name of the standard input, which may hold a scene or a photograph, once; and of the standard output. */
    public static final Path PIPE = Path.of("-");

    /** The version of the format. */
    static final int VERSION = 1;

    static final String VERSION_KEY = "version";

    private StudioReader() {}

    /**
     * Reads a scene file, or the scene that a saved photograph holds.
     *
     * @throws MistakeException if the file cannot be read, or there are mistakes in it
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
     * @throws MistakeException if there are mistakes in the text
     */
    public static Studio read(String text, String name, Path folder) {
        return studio(text, new Problems(name), folder);
    }

    /**
     * Uses a scene that was read from a file.
     *
     * @throws MistakeException at the place in the file of what is refused, if that shows only now
     */
    public static <T> T used(Path file, Supplier<T> use) {
        try {
            return use.get();
        } catch (InvalidPropertyException refused) {
            throw mistake(file, refused);
        }
    }

    /**
     * What is wrong with a part of a scene that was read from a file, if it shows only when the scene is used; with the
     * place of that part in the file.
     *
     * @param refused names the way to the part as its property
     * @throws MistakeException if the file can no longer be read
     */
    private static MistakeException mistake(Path file, InvalidPropertyException refused) {
        Problems problems = new Problems(file.toString());
        if (file.equals(PIPE)) {
            // it cannot be read again to find the place
            return problems.wholeFile(refused.getMessage());
        }
        JsonValue part = JsonParsing.parse(new SceneText(file, problems).read(), problems);
        for (Object step :
                StudioPath.parse(refused.property()).orElse(StudioPath.ROOT).steps()) {
            if (part instanceof JsonObject object && object.members().containsKey(step)) {
                part = object.members().get(step).value();
            } else if (part instanceof JsonList list
                    && step instanceof Integer index
                    && index < list.values().size()) {
                part = list.values().get(index);
            }
        }
        problems.add(part, refused.property(), refused.problem());
        return problems.exception();
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
        Object studio = reader.record(Studio.class, root, "", List.of(VERSION_KEY), Studio.DEFAULT);
        problems.throwIfAny();
        return (Studio) studio;
    }

    private static boolean isKnown(JsonValue version) {
        // as for all whole numbers, 1.0 is as good as 1
        return version instanceof JsonNumber number && number.text().matches(VERSION + "(\\.0+)?");
    }
}
