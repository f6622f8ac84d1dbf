package tompkins.explain;

import java.util.List;
import java.util.Optional;
import java.util.stream.DoubleStream;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.joml.Vector3d;
import tompkins.property.Descriptions;
import tompkins.property.Require;
import tompkins.ray.Colour;
import tompkins.studio.Studio;
import tompkins.studio.StudioPath;
import tompkins.surface.ColouredSurface;

/** Warns of colours that look as if white were 255, as in other programs. */
final class BrightColours {

    /** The brightest that a surface is likely to be on purpose. */
    private static final double BRIGHTEST = 2;

    /** No lamp of a scene in which white is 1 is likely to have whole numbers above this. */
    private static final double LIKELY = 99;

    private static final double LARGEST = 255;

    /** In a list that is longer, only so many are looked at. */
    private static final int MOST = 1000;

    private BrightColours() {}

    /** A warning of the first such colour, if there is one. */
    static Optional<String> warning(Studio studio) {
        return found(studio, StudioPath.ROOT).findFirst();
    }

    private static Stream<String> found(Object whole, StudioPath path) {
        if (whole instanceof List<?> list) {
            return IntStream.range(0, Math.min(list.size(), MOST))
                    .boxed()
                    .flatMap(place -> found(list.get(place), path.then(place)));
        }
        if (whole instanceof Colour || !(whole instanceof Record)) {
            return Stream.empty();
        }
        return Descriptions.components(whole.getClass()).stream().flatMap(component -> {
            Object part = Descriptions.value(component, whole);
            StudioPath way = path.then(component.getName());
            return part instanceof Colour colour && isBright(colour, whole)
                    ? Stream.of(way + " is "
                            + Require.text(new Vector3d(colour.red(), colour.green(), colour.blue()))
                            + ", brighter than white, which is 1; colours go from 0 to 1, not to 255")
                    : found(part, way);
        });
    }

    private static boolean isBright(Colour colour, Object owner) {
        double largest = colour.brightest();
        boolean isWhole =
                DoubleStream.of(colour.red(), colour.green(), colour.blue()).allMatch(part -> part == Math.rint(part));
        // surfaces are made a little brighter than white on purpose, lamps much brighter
        return owner instanceof ColouredSurface
                ? largest > BRIGHTEST
                : isWhole && largest > LIKELY && largest <= LARGEST;
    }
}
