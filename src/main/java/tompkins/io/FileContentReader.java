package tompkins.io;

import java.io.IOException;
import java.util.Base64;
import java.util.List;
import tompkins.file.FileException;
import tompkins.io.JsonValue.JsonObject;
import tompkins.io.JsonValue.JsonText;
import tompkins.io.JsonValue.Member;
import tompkins.ray.FileContent;

/** Makes what files hold from JSON: the name of a file, or a name with the bytes of the file in base 64. */
final class FileContentReader {

    static final String NAME = "name";
    static final String BASE64 = "base64";

    private final Problems problems;
    private final SceneFolder folder;

    FileContentReader(Problems problems, SceneFolder folder) {
        this.problems = problems;
        this.folder = folder;
    }

    /** What the file holds, or null if a mistake was noted. */
    FileContent read(JsonValue value, String path, FileKind kind) {
        try {
            if (value instanceof JsonText name) {
                return folder.content(name.text(), kind);
            }
            if (value instanceof JsonObject object && hold(object, NAME) && hold(object, BASE64)) {
                boolean clear = problems.noteUnknownKeys(object, path, List.of(NAME, BASE64));
                byte[] content = decoded(object.members().get(BASE64).value(), path);
                return clear && content != null ? kind.parse(content, text(object, NAME), FileKind.Files.NONE) : null;
            }
            String allowed = "the name of " + kind.noun() + " in quotes, or an object with the texts name and base64";
            problems.add(value, path, "must be " + allowed + ", was " + value.shown());
        } catch (FileException unusable) {
            problems.add(value, path, unusable.getMessage());
        } catch (IOException unusable) {
            problems.add(value, path, unusable.getMessage() + ", was " + value.shown());
        }
        return null;
    }

    private static boolean hold(JsonObject object, String key) {
        Member member = object.members().get(key);
        return member != null && member.value() instanceof JsonText;
    }

    private static String text(JsonObject object, String key) {
        return ((JsonText) object.members().get(key).value()).text();
    }

    /** The bytes that a text encodes, or null if a mistake was noted. */
    private byte[] decoded(JsonValue base64, String path) {
        try {
            return Base64.getDecoder().decode(((JsonText) base64).text());
        } catch (IllegalArgumentException wrong) {
            problems.add(
                    base64, path + "." + BASE64, "must be the bytes of the file in base 64, was " + base64.shown());
            return null;
        }
    }
}
