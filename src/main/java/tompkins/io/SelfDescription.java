package tompkins.io;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.util.Optional;
import java.util.Properties;
import tompkins.camera.PanoramicCamera;
import tompkins.camera.StereoLayout;
import tompkins.image.Panorama;
import tompkins.image.PhotographInfo;
import tompkins.property.AddedTypes;
import tompkins.property.OneLine;
import tompkins.studio.Studio;
import tompkins.studio.View;

/** What the file of a photograph says: its title, the program that took it, and the scene, to take it again. */
public final class SelfDescription {

    private static final String PROPERTIES = "Program.properties";

    /** The beginning of the title of a picture that is not a photograph. */
    private static final String MEASURED = "Measured, not a photograph: ";

    private SelfDescription() {}

    /**
     * What the file of a studio's photograph says about itself.
     *
     * @throws tompkins.property.InvalidPropertyException if the scene is too long to travel inside
     */
    public static PhotographInfo of(Studio studio) {
        String title = (studio.view() == View.MEASURED ? MEASURED : "") + OneLine.of(studio.title());
        boolean stereoPair = studio.camera().stereo().layout() == StereoLayout.SIDE_BY_SIDE;
        return new PhotographInfo(
                title, program(), StudioWriter.writeSelfContained(studio), panorama(studio), stereoPair, "");
    }

    private static Optional<Panorama> panorama(Studio studio) {
        return studio.camera() instanceof PanoramicCamera camera
                        && !camera.stereo().layout().hasHalves()
                ? Optional.of(new Panorama(camera.horizontalAngleDegrees(), camera.verticalAngleDegrees()))
                : Optional.empty();
    }

    /** Name and version of the program, and of the jars that add types to it. */
    public static String program() {
        return "Tompkins " + version() + AddedTypes.withJars();
    }

    /** The version of the program, such as 1.2.0. */
    public static String version() {
        // a resource bundle would delay a cold start
        Properties program = new Properties();
        try (InputStream in = SelfDescription.class.getResourceAsStream(PROPERTIES)) {
            program.load(in);
        } catch (IOException broken) {
            throw new UncheckedIOException(broken);
        }
        return program.getProperty("version");
    }
}
