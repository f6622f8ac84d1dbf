package tompkins.ray;

import static org.assertj.core.api.Assertions.assertThat;

import java.lang.reflect.Field;
import java.lang.reflect.Method;
import java.lang.reflect.Modifier;
import org.junit.jupiter.api.Test;

/** Where Java puts the fields of what is padded. */
class PaddedTest {

    /** The length of a cache line, in bytes. */
    private static final long LINE = 64;

    @Test
    void fieldsLieALineBehindTheStart() throws ReflectiveOperationException {
        // by reflection, since javac warns of each mention of the class
        Class<?> unsafe = Class.forName("sun.misc.Unsafe");
        Field instance = unsafe.getDeclaredField("theUnsafe");
        instance.setAccessible(true);
        Method offset = unsafe.getMethod("objectFieldOffset", Field.class);
        for (Class<?> padded : new Class<?>[] {RayCounts.class, RayPacket.class, Small.class}) {
            for (Field field : padded.getDeclaredFields()) {
                if (!Modifier.isStatic(field.getModifiers())) {
                    assertThat((long) offset.invoke(instance.get(null), field))
                            .as(field.toString())
                            .isGreaterThanOrEqualTo(LINE);
                }
            }
        }
    }

    /** Has fields of all lengths that might fill a gap. */
    @SuppressWarnings("unused") // only their places count
    private static final class Small extends Padded {
        private boolean flag;
        private short number;
        private int count;
        private Object other;
    }
}
