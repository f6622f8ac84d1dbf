package tompkins.io;

import java.util.Locale;
import java.util.ResourceBundle;
import tompkins.image.PhotographInfo;
import tompkins.studio.Studio;

/** What the file of a photograph says about itself: its title, the program that took it, and the scene, to take it again. */
public final class SelfDescription {

    private static final String BUNDLE = "tompkins.io.Program";

    private SelfDescription() {}

    /**
     * What the file of a studio's photograph says about itself.
     *
     * @throws tompkins.property.InvalidPropertyException if the scene is too long to travel inside
     */
    public static PhotographInfo of(Studio studio) {
        String title = studio.title().replaceAll("\\p{Cntrl}+", " ");
        return new PhotographInfo(title, program(), StudioWriter.writeSelfContained(studio));
    }

    /** Name and version of the program. */
    public static String program() {
        return "Tompkins " + ResourceBundle.getBundle(BUNDLE, Locale.ROOT).getString("version");
    }
}
