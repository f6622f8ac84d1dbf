package tompkins;

import java.lang.annotation.ElementType;
import java.lang.annotation.Retention;
import java.lang.annotation.RetentionPolicy;
import java.lang.annotation.Target;
import org.junit.jupiter.api.extension.ConditionEvaluationResult;
import org.junit.jupiter.api.extension.ExecutionCondition;
import org.junit.jupiter.api.extension.ExtendWith;
import org.junit.jupiter.api.extension.ExtensionContext;

/**
 * A test, or a class of tests, that runs only with {@code -Dtompkins.tests=all}: it takes long, or it needs the mouse,
 * the keyboard and the focus of a whole screen for itself.
 */
@Target({ElementType.TYPE, ElementType.METHOD})
@Retention(RetentionPolicy.RUNTIME)
@ExtendWith(Thorough.Condition.class)
public @interface Thorough {

    /** Asks what is wanted. */
    final class Condition implements ExecutionCondition {

        @Override
        public ConditionEvaluationResult evaluateExecutionCondition(ExtensionContext context) {
            return TestRun.THOROUGH
                    ? ConditionEvaluationResult.enabled("everything is tried")
                    : ConditionEvaluationResult.disabled("runs with -Dtompkins.tests=all");
        }
    }
}
