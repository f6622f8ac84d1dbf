package tompkins.image;

import java.util.Optional;
import tompkins.property.InvalidPropertyException;

/**
 * What a photograph's file says about itself.
 *
 * @param title what it shows, one line; may be empty
 * @param software the program that took it, with its version; may be empty
 * @param sceneJson the scene from which it can be taken again, a JSON object; empty if there is none
 * @param panorama what it shows of the sphere around the camera, if it is a panorama
 * @param stereoPair whether its left half is for the left eye and its right half for the right eye
 * @param description what else is to be known about it, one line, which only PNG keeps; may be empty
 */
public record PhotographInfo(
        String title,
        String software,
        String sceneJson,
        Optional<Panorama> panorama,
        boolean stereoPair,
        String description) {

    /** The most characters that a scene may have; a file that claims more is refused. */
    public static final int LONGEST_SCENE = 16 << 20;

    /** The most bytes that such a scene takes in a file, where a character may become an escape of six. */
    static final int LONGEST_STORED_SCENE = 6 * LONGEST_SCENE;

    /** A photograph that says nothing about itself. */
    public static final PhotographInfo NONE = new PhotographInfo("", "", "");

    /**
     * Checks the scene.
     *
     * @throws InvalidPropertyException if it is too long
     */
    public PhotographInfo {
        if (sceneJson.length() > LONGEST_SCENE) {
            throw new InvalidPropertyException(
                    "scene",
                    "at most " + LONGEST_SCENE + " characters long, with its pictures, to travel inside a photograph",
                    sceneJson.length());
        }
    }

    /** What a photograph says about itself that is neither a panorama nor a stereo pair, and has no description. */
    public PhotographInfo(String title, String software, String sceneJson) {
        this(title, software, sceneJson, Optional.empty(), false, "");
    }

    /** The same with another description. */
    public PhotographInfo withDescription(String other) {
        return new PhotographInfo(title, software, sceneJson, panorama, stereoPair, other);
    }
}
