package tompkins.surface;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.SplittableRandom;
import java.util.stream.Stream;
import org.joml.Vector3d;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import tompkins.fuzz.RandomStudio;
import tompkins.property.Descriptions;
import tompkins.ray.Hit;
import tompkins.ray.Ray;
import tompkins.ray.SurfaceCoordinates;

/** What every surface says of itself, against what it makes of rays that hit it. */
class SurfaceContractTest {

    private static final int SURFACES = 60;
    private static final int HITS = 100;

    /** Coordinates go from minus to plus this: many tiles. */
    private static final double REACH = 100;

    private final SplittableRandom random = new SplittableRandom(17);

    static Stream<Class<?>> types() {
        return Descriptions.members(Surface.class).stream();
    }

    private Vector3d vector() {
        return new Vector3d(random.nextDouble() - 0.5, random.nextDouble() - 0.5, random.nextDouble() - 0.5);
    }

    /** A ray of no width: it meets one point of a pattern. */
    private Ray ray() {
        Vector3d direction = vector().normalize();
        return Ray.from(0, 0, 0, direction.x, direction.y, direction.z, 0);
    }

    /** A hit at a random point, with coordinates only if the surface asks for them. */
    private Hit hit(Ray ray, Surface surface) {
        Vector3d normal = vector().normalize();
        Vector3d right = vector().cross(normal).normalize();
        Vector3d up = new Vector3d(normal).cross(right);
        SurfaceCoordinates coordinates = new SurfaceCoordinates(
                random.nextDouble(-REACH, REACH),
                random.nextDouble(-REACH, REACH),
                right.x,
                right.y,
                right.z,
                up.x,
                up.y,
                up.z);
        return Hit.blank()
                .set(ray, 1, normal.x, normal.y, normal.z, null, 0, surface.usesCoordinates() ? coordinates : null);
    }

    /** Or everywhere or nowhere, if a surface says so. Mirrors throw shadows: their light goes on, but goes back. */
    @ParameterizedTest
    @MethodSource("types")
    void shadowsFallWhereNoLightPasses(Class<?> type) {
        for (int seed = 0; seed < SURFACES; seed++) {
            Surface surface = RandomStudio.surface(seed, type);
            for (int i = 0; i < HITS; i++) {
                Ray ray = ray();
                Hit hit = hit(ray, surface);
                Response response = surface.respond(ray, hit, DarkTracer.DARK);
                Ray next = response.next();
                boolean isDark = surface.throwsShadowAt(ray, hit);
                if (surface.shadow() != Shadow.BY_POINT) {
                    assertThat(isDark).as("shadow of %s", surface).isEqualTo(surface.shadow() == Shadow.ALWAYS);
                }
                if (isDark) {
                    boolean passes = next != null && hit.cosine(next) * hit.cosine(ray) > 0;
                    assertThat(passes)
                            .as("light passes where %s throws a shadow", surface)
                            .isFalse();
                } else {
                    boolean glows = response.light().brightest() > 0;
                    assertThat(next != null || glows)
                            .as("light goes on (or comes from there) where %s throws no shadow", surface)
                            .isTrue();
                }
            }
        }
    }

    /** Patterns with a part that sends rays on may have none of it where a picture is dark or bright all over. */
    @ParameterizedTest
    @MethodSource("types")
    void raysGoOnIfASurfaceSaysSo(Class<?> type) {
        boolean isPattern =
                Descriptions.components(type).stream().anyMatch(component -> component.getType() == Surface.class);
        for (int seed = 0; seed < SURFACES; seed++) {
            Surface surface = RandomStudio.surface(seed, type);
            boolean goesOn = false;
            for (int i = 0; i < HITS; i++) {
                Ray ray = ray();
                goesOn |=
                        surface.respond(ray, hit(ray, surface), DarkTracer.DARK).next() != null;
            }
            if (goesOn || !isPattern) {
                assertThat(surface.continuation() != Continuation.NONE)
                        .as("rays go on from %s", surface)
                        .isEqualTo(goesOn);
            }
        }
    }
}
