package tompkins.io;

import java.io.IOException;
import java.util.Base64;
import java.util.List;
import tompkins.image.PictureException;
import tompkins.image.PictureFile;
import tompkins.io.JsonValue.JsonObject;
import tompkins.io.JsonValue.JsonText;
import tompkins.io.JsonValue.Member;
import tompkins.ray.PixelPicture;

/** Makes pictures from JSON: the name of a file, or a name with the bytes of the file in base 64. */
final class PictureReader {

    static final String NAME = "name";
    static final String BASE64 = "base64";

    private final Problems problems;
    private final PictureFolder folder;

    PictureReader(Problems problems, PictureFolder folder) {
        this.problems = problems;
        this.folder = folder;
    }

    /** The picture, or null if a mistake was noted. */
    PixelPicture read(JsonValue value, String path) {
        try {
            if (value instanceof JsonText name) {
                return folder.picture(name.text());
            }
            if (value instanceof JsonObject object && hold(object, NAME) && hold(object, BASE64)) {
                return Refusal.noteUnknownKeys(problems, object, path, List.of(NAME, BASE64))
                        ? PictureFile.read(decoded(text(object, BASE64)), text(object, NAME))
                        : null;
            }
            String allowed = "the name of a picture file in quotes, or an object with the texts name and base64";
            problems.add(value, path, "must be " + allowed + ", was " + value.shown());
        } catch (PictureException unusable) {
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

    private static byte[] decoded(String base64) throws IOException {
        try {
            return Base64.getDecoder().decode(base64);
        } catch (IllegalArgumentException wrong) {
            throw new IOException("the value of base64 is not base 64", wrong);
        }
    }
}
